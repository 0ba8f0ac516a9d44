/* Ranks what the search finds: pages that explain come before the reference, and the reference before sources. */
globalThis.Scorer = {
    score: ([page, , , , score]) =>
        score + (page.startsWith("_modules/") ? -100 : /^(reference|development)\//.test(page) ? 0 : 100),
    objNameMatch: 11,
    objPartialMatch: 6,
    objPrio: { 0: 15, 1: 5, 2: -5 },
    objPrioDefault: 0,
    title: 15,
    partialTitle: 7,
    term: 5,
    partialTerm: 2,
};
