package rasterlab.grader.web

import kotlinx.html.FlowContent
import kotlinx.html.label
import kotlinx.html.link
import kotlinx.html.script
import kotlinx.html.span
import kotlinx.html.textArea
import java.util.Properties

/** The path of the scripts that others wrote. */
internal const val LIBRARIES = "/assets/lib"
private const val ABOUT_EDITOR = "/META-INF/maven/org.webjars.npm/codemirror/pom.properties"

/** The path of CodeMirror's files, which names their version. */
private val LIBRARY: String by lazy {
    val about = checkNotNull(PageTexts::class.java.getResourceAsStream(ABOUT_EDITOR)) { "$ABOUT_EDITOR is missing" }
    "$LIBRARIES/codemirror/${about.use { Properties().apply { load(it) } }.getProperty("version")}"
}

/** The media types of languages as the editor calls them; a text in another is shown without colors. */
private val MODES = mapOf("java" to "text/x-java", "json" to "application/json")

/**
 * A field for a source, which [editor] makes an editor where the browser lets it.
 *
 * @param ending of a file with such a text, as `java`
 * @param rows that it has at least
 */
internal fun FlowContent.sourceField(
    title: String,
    ending: String,
    text: String,
    rows: Int,
) = label {
    span { +title }
    textArea(rows = "$rows") {
        name = "source"
        attributes["spellcheck"] = "false"
        attributes["data-editor"] = MODES[ending] ?: "text/plain"
        // A browser leaves out the line end that a text begins with.
        +(if (text.startsWith('\n')) "\n$text" else text)
    }
}

/** The files of the editor, below the fields on a page. */
internal fun FlowContent.editor() {
    link(rel = "stylesheet", href = "$LIBRARY/lib/codemirror.css")
    link(rel = "stylesheet", href = "/assets/editor.css")
    val parts = listOf("lib/codemirror", "mode/clike/clike", "mode/javascript/javascript", "addon/edit/matchbrackets")
    for (part in parts) script(src = "$LIBRARY/$part.js") { defer = true }
    script(src = "/assets/editor.js") { defer = true }
}
