package rasterlab.grader.web.comment

import kotlinx.html.FORM
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.button
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.id
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.option
import kotlinx.html.p
import kotlinx.html.select
import kotlinx.html.span
import kotlinx.html.summary
import kotlinx.html.textArea
import rasterlab.grader.comment.CommentText
import rasterlab.grader.comment.Comments
import rasterlab.grader.comment.LineComment
import rasterlab.grader.course.Identity
import rasterlab.grader.storage.Secrets
import rasterlab.grader.web.PageTexts

/** The characters of a kept comment that tell it apart where it is chosen. */
private const val BEGINNING = 60

/** The form that begins a thread: of staff a comment, of the student a question. */
internal fun FlowContent.newThread(desk: CommentDesk) {
    val texts = desk.texts
    val kind = if (desk.who is Identity.StaffIdentity) "staff" else "student"
    h2 { +texts.say("comment.new.$kind") }
    p { +texts.say("comment.about.$kind") }
    commentForm(desk, desk.address, "new") {
        val typed = desk.typedIn("new")
        div("lines") {
            lineField(texts.say("comment.first"), "line", typed?.get("line"), desk)
            lineField(texts.say("comment.last"), "last", typed?.get("last"), desk)
        }
        words(desk, "new", "")
        button { +texts.say("comment.do.$kind") }
    }
}

/** The form that answers in a thread, and the button that closes one that is open. */
internal fun FlowContent.answering(
    desk: CommentDesk,
    thread: LineComment,
) {
    val name = "answer-${thread.id}"
    details {
        open = desk.typedIn(name) != null
        summary { +desk.texts.say("comment.answer") }
        commentForm(desk, "${desk.address}/${thread.id}/answer", name) {
            words(desk, name, "")
            button { +desk.texts.say("comment.answer.do") }
        }
    }
    if (thread.open) {
        form("${desk.address}/${thread.id}/answered", method = FormMethod.post) {
            button(classes = "plain") { +desk.texts.say("comment.settle") }
        }
    }
}

/**
 * Lets whoever looks change and delete their own comment, and staff keep one of theirs for others.
 *
 * @param answered whether it stays, since somebody has answered
 */
internal fun FlowContent.controls(
    desk: CommentDesk,
    one: LineComment,
    answered: Boolean,
) {
    val address = "${desk.address}/${one.id}"
    if (one.by == desk.who.id) {
        val name = "edit-${one.id}"
        details {
            open = desk.typedIn(name) != null
            summary { +desk.texts.say(if (answered) "comment.change" else "comment.change.delete") }
            commentForm(desk, "$address/edit", name) {
                words(desk, name, one.text, choose = false)
                button { +desk.texts.say("comment.save") }
            }
            if (!answered) {
                form("$address/delete", method = FormMethod.post) {
                    button(classes = "plain") { +desk.texts.say("comment.delete") }
                }
            }
        }
    }
    if (desk.who is Identity.StaffIdentity && one.role != "student") {
        val name = "keep-${one.id}"
        details {
            open = desk.typedIn(name) != null
            summary { +desk.texts.say("comment.keep") }
            commentForm(desk, "$address/keep", name) {
                keptName(desk.texts, desk.typedIn(name)?.get("name").orEmpty())
                button { +desk.texts.say("comment.keep.do") }
            }
        }
    }
}

private fun FlowContent.commentForm(
    desk: CommentDesk,
    address: String,
    name: String,
    content: FORM.() -> Unit,
) = form(address, method = FormMethod.post) {
    if (desk.typedIn(name) != null) id = "refused"
    input(InputType.hidden, name = CommentDesk.FORM) { value = name }
    input(InputType.hidden, name = ONCE) { value = Secrets.newId() }
    content()
}

private fun FlowContent.lineField(
    label: String,
    field: String,
    typed: String?,
    desk: CommentDesk,
) = label {
    span { +label }
    input(InputType.number, name = field) {
        min = "1"
        max = "${Comments.linesOf(desk.submission.source)}"
        value = typed.orEmpty()
    }
}

/**
 * The text of a comment; to staff also those that the course keeps.
 *
 * @param text what stands there at first
 * @param choose whether a kept one can be chosen
 */
private fun FlowContent.words(
    desk: CommentDesk,
    form: String,
    text: String,
    choose: Boolean = true,
) {
    val choices = if (choose) desk.kept else emptyList()
    if (choices.isNotEmpty()) {
        label {
            span { +desk.texts.say("comment.kept") }
            select {
                name = "kept"
                option {
                    value = ""
                    +desk.texts.say("comment.kept.none")
                }
                choices.forEach { one ->
                    option {
                        value = one.id
                        selected = desk.typedIn(form)?.get("kept") == one.id
                        +desk.texts.say("comment.kept.one", one.name, beginning(one.text))
                    }
                }
            }
        }
    }
    wordsField(
        desk.texts.say(if (choices.isEmpty()) "comment.text" else "comment.text.more"),
        desk.typedIn(form)?.get("text") ?: text,
        mandatory = choices.isEmpty(),
    )
}

internal fun FlowContent.wordsField(
    label: String,
    text: String,
    mandatory: Boolean = true,
) = label {
    span { +label }
    textArea(rows = "4", classes = "words") {
        name = "text"
        required = mandatory
        maxLength = "${CommentText.MOST}"
        // A browser leaves out the line end that a text begins with.
        +(if (text.startsWith('\n')) "\n$text" else text)
    }
}

internal fun FlowContent.keptName(
    texts: PageTexts,
    typed: String,
) = label {
    span { +texts.say("comment.keep.name") }
    input(InputType.text, name = "name") {
        value = typed
        maxLength = "80"
        required = true
        attributes["autocomplete"] = "off"
    }
}

internal fun beginning(text: String): String {
    val line = text.replace('\n', ' ')
    return if (line.length > BEGINNING) line.take(BEGINNING) + "…" else line
}
