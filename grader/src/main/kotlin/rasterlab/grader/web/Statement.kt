package rasterlab.grader.web

import org.commonmark.parser.Parser
import org.commonmark.renderer.html.HtmlRenderer

/** Markdown as HTML in which nothing but Markdown's own elements survives. */
fun markdownAsHtml(markdown: String): String =
    HtmlRenderer
        .builder()
        .escapeHtml(true)
        .sanitizeUrls(true)
        .build()
        .render(Parser.builder().build().parse(markdown))
