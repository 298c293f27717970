package rasterlab.grader.web

import rasterlab.grader.comment.CommentedLines
import rasterlab.grader.course.AuditEntry
import rasterlab.grader.course.StaffRole
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.rules.LimitField
import java.time.DateTimeException
import java.time.Instant

private val COUNTS = Regex("[a-z]+ (-?\\d+), [a-z]+ (-?\\d+)")
private val DAYS = Regex("(-?\\d+) days")
private val POINTS = Regex("(-?\\d+), before (-?\\d+)")
private val REGRADED = Regex("(\\S+) ([a-z]+) (\\d+)")
private val LIMIT = Regex("([a-zA-Z]+) (\\d+|–)")
private val CHANGE = Regex("([a-zA-Z]+): (.*)")
private val LINES = Regex("(\\d+)(?:–(\\d+))?")
private val NEXT_CHANGE = Regex(", (?=[a-zA-Z]+: )")

/** Tells more of a change in the words of the page; what was noted, in English, where there are none for it. */
internal fun PageTexts.detail(
    one: AuditEntry,
    exercises: Exercises,
): String =
    when (one.action) {
        "roster" -> told(one, COUNTS, "roster")
        "export", "delete" -> told(one, COUNTS, "student")
        "clone" -> told(one, DAYS, "clone")
        "regrade" -> regraded(one, exercises)
        "points" -> told(one, POINTS, "points")
        "limits" -> limits(one.detail)
        "extension" -> moment(one.detail)
        "exercises" -> one.detail.split(", ").joinToString { exercise(it, exercises) }
        "comment", "comment-answer", "comment-edit", "comment-delete", "comment-settle" -> lines(one.detail)
        "complaint-accept", "complaint-decline" -> case(one, exercises)
        "rules" -> changes(one, "rules")
        "exam-change" -> changes(one, "exams")
        "staff-add", "staff-token", "staff-revoke" -> role(one.detail)
        "staff-course" -> one.detail.split(" → ").joinToString(" → ") { if (it == "*") say("staff.course.all") else it }
        else -> one.detail
    }

/** The title of an exercise; its id where it is not here any more. */
internal fun PageTexts.exercise(
    id: String,
    exercises: Exercises,
): String = exercises.find(id)?.title(language) ?: id

private fun PageTexts.case(
    one: AuditEntry,
    exercises: Exercises,
): String = one.exercise?.let(exercises::find)?.caseTitle(one.detail, language) ?: one.detail

private fun PageTexts.lines(text: String): String {
    val (first, last) = LINES.matchEntire(text)?.destructured ?: return text
    return place(CommentedLines(first.toInt(), last.ifEmpty { first }.toInt()))
}

private fun PageTexts.told(
    one: AuditEntry,
    form: Regex,
    word: String,
): String {
    val numbers = form.matchEntire(one.detail)?.groupValues?.drop(1) ?: return one.detail
    return say("audit.detail.$word", *numbers.map { it.replace('-', '−') }.toTypedArray())
}

private fun PageTexts.regraded(
    one: AuditEntry,
    exercises: Exercises,
): String {
    val (exercise, choice, count) = REGRADED.matchEntire(one.detail)?.destructured ?: return one.detail
    val chosen = firstOf("audit.detail.regrade.$choice", "regrade.of.$choice") ?: choice
    val told = say("audit.detail.regrade", chosen, count)
    val case = one.case ?: return told
    return say("audit.detail.regrade.case", told, exercises.find(exercise)?.caseTitle(case, language) ?: case)
}

/** Tells each limit by its name on the page of rules; one that is not set is what the server allows. */
private fun PageTexts.limits(text: String): String =
    text.split(", ").joinToString("; ") { part ->
        val (code, number) = LIMIT.matchEntire(part)?.destructured ?: return@joinToString part
        val field = LimitField.entries.find { it.code == code } ?: return@joinToString part
        "${say("limits.${field.code}")}: $number"
    }

/** Tells fields that were changed, each as it was and as it is, by the names that they have on the page of [kind]. */
private fun PageTexts.changes(
    one: AuditEntry,
    kind: String,
): String =
    one.detail.split(NEXT_CHANGE).joinToString("; ") { change ->
        val (field, values) = CHANGE.matchEntire(change)?.destructured ?: return@joinToString change
        val name = firstOf("audit.field.$field", "$kind.column.$field", "$kind.$field") ?: field
        "$name: " + values.split(" → ").joinToString(" → ") { firstOf("$kind.$field.$it") ?: moment(it) }
    }

private fun PageTexts.moment(text: String): String =
    try {
        time(Instant.parse(text))
    } catch (other: DateTimeException) {
        text
    }

private fun PageTexts.role(text: String): String {
    val code = text.substringBefore(", ")
    if (StaffRole.entries.none { it.code == code }) return text
    return say("staff.role.$code") + text.removePrefix(code)
}
