/**
 * Versions of the site side by side: the list of them is one file that all versions read, so that an old one knows of
 * those that came later. Each entry has a `version` and the `address` of its first page, relative to the list. Where
 * the list cannot be had, as in files without a server, nothing is shown.
 */
const box = document.querySelector(".versions");

/** The page of the same name in another version, or its first page if it has none of that name. */
async function samePage(own, home) {
  const folder = new URL(".", own);
  const wanted = new URL(location.href.slice(folder.href.length), home);
  const answer = await fetch(wanted, { method: "HEAD" });
  return answer.ok ? wanted : home;
}

async function show() {
  const list = new URL(box.dataset.file, location.href);
  const answer = await fetch(list, { cache: "no-cache" }); // a version may have come since
  if (!answer.ok) {
    return;
  }
  const versions = (await answer.json()).map(({ version, address }) => ({ version, home: new URL(address, list) }));
  const own = versions.find(({ version }) => version === box.dataset.version);
  if (!own || versions.length < 2) {
    return;
  }
  const select = box.querySelector("select");
  select.append(...versions.map(({ version }) => new Option(version, version, false, version === own.version)));
  select.addEventListener("change", async () => {
    location.assign(await samePage(own.home, versions[select.selectedIndex].home));
  });
  box.hidden = false;
}

if (box && location.protocol !== "file:") {
  show();
}
