/* Tables of a run: numbers that the decisions of a page look up. */
#ifndef TDMF_KERNEL_TABLES_H
#define TDMF_KERNEL_TABLES_H

#include <stdbool.h>

/* The first row also stands for all rows before it, the last row for all rows after it. `entry` computes
 * numbers, for example drawn ones. Without rows and `entry`, the page's own rows are used. */
typedef struct {
    int row_count, column_count;
    const double *rows, *d_rows; /* d_rows: variations of the rows for each seed; NULL: they do not vary */
    double (*entry)(const void *context, double row, int column);
    const void *context;
} tdmf_table;

static inline bool is_given(const tdmf_table *tables, int table) {
    return tables && ((tables[table].rows && tables[table].row_count > 0) || tables[table].entry);
}

static inline int place_in_table(const tdmf_table *t, int column, double row) {
    const int last = t->row_count - 1, at = row > 0.0 ? (row < last ? (int)row : last) : 0;
    return at * t->column_count + column;
}

static inline double looked_up(const tdmf_table *tables, int table, int column, double row, double own) {
    if (!is_given(tables, table)) {
        return own;
    }
    const tdmf_table *t = &tables[table];
    if (t->entry) {
        return t->entry(t->context, row, column);
    }
    return t->rows[place_in_table(t, column, row)];
}

static inline double variation_looked_up(const tdmf_table *tables, int table, int column, int seed,
                                         double row, double of_own) {
    if (!is_given(tables, table)) {
        return of_own;
    }
    const tdmf_table *t = &tables[table];
    return t->d_rows ? t->d_rows[seed * t->row_count * t->column_count + place_in_table(t, column, row)]
                     : 0.0;
}

#endif
