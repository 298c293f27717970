package rasterlab.grader.web

import kotlinx.html.FlowContent
import kotlinx.html.TD
import kotlinx.html.ThScope
import kotlinx.html.div
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr

/**
 * A table with a row for each of [all]; on a phone each row stands as a list, in which every cell tells its column.
 *
 * @param columns their names, and what a cell shows
 */
internal fun <T> FlowContent.stacked(
    columns: List<Pair<String, FlowContent.(T) -> Unit>>,
    all: List<T>,
) = table("students stacked") {
    thead { tr { columns.forEach { (name) -> th(scope = ThScope.col) { +name } } } }
    tbody {
        all.forEach { one ->
            tr {
                columns.forEach { (name, content) ->
                    td {
                        column(name)
                        div { content(one) }
                    }
                }
            }
        }
    }
}

/** Names the column for a phone, which shows no row of headings. */
internal fun TD.column(name: String) {
    attributes["data-column"] = name
}
