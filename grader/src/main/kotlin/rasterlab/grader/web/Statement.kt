package rasterlab.grader.web

import org.commonmark.ext.gfm.tables.TablesExtension
import org.commonmark.parser.Parser
import org.commonmark.renderer.html.HtmlRenderer

private val EXTENSIONS = listOf(TablesExtension.create())

/** Markdown, with tables, as HTML in which nothing but Markdown's own elements survives. */
fun markdownAsHtml(markdown: String): String =
    HtmlRenderer
        .builder()
        .extensions(EXTENSIONS)
        .escapeHtml(true)
        .sanitizeUrls(true)
        .build()
        .render(
            Parser
                .builder()
                .extensions(EXTENSIONS)
                .build()
                .parse(markdown),
        )
