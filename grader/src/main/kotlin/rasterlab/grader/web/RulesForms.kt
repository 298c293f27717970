package rasterlab.grader.web

import io.ktor.http.Parameters
import kotlinx.html.FORM
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.button
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.li
import kotlinx.html.option
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.select
import kotlinx.html.span
import kotlinx.html.ul
import rasterlab.grader.course.Enrolled
import rasterlab.grader.rules.CountingPolicy
import rasterlab.grader.rules.ExerciseRules
import rasterlab.grader.rules.Extension
import rasterlab.grader.rules.RuleField
import rasterlab.grader.rules.named
import java.time.Instant
import java.time.format.DateTimeFormatter

/** Writes a time as a browser's field for a date and a time has it. */
internal val FIELD_TIME = DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm:ss")

/** The rules of an exercise to fill in, with what was typed before where that was refused. */
internal fun FlowContent.rulesForm(
    texts: PageTexts,
    address: String,
    held: ExerciseRules,
    typed: Parameters?,
) = section("card") {
    h2 { +texts.say("rules.set") }
    form(address, method = FormMethod.post) {
        fun time(moment: Instant?) = moment?.let { FIELD_TIME.format(it.atZone(held.zone)) }.orEmpty()
        rule(texts, RuleField.OPENS, InputType.dateTimeLocal, time(held.opens), typed)
        rule(texts, RuleField.DEADLINE, InputType.dateTimeLocal, time(held.due), typed)
        rule(texts, RuleField.ZONE, InputType.text, held.zone.named(), typed)
        rule(texts, RuleField.LATE_DAYS, InputType.number, held.lateDays?.toString().orEmpty(), typed)
        rule(texts, RuleField.LATE_PENALTY, InputType.number, "${held.latePenalty}", typed)
        rule(texts, RuleField.ATTEMPTS, InputType.number, held.attempts?.toString().orEmpty(), typed)
        label {
            span { +texts.say("rules.policy") }
            val chosen = typed?.get(RuleField.POLICY.code) ?: held.policy.code
            select {
                name = RuleField.POLICY.code
                CountingPolicy.entries.forEach { one ->
                    option {
                        value = one.code
                        selected = one.code == chosen
                        +texts.say("rules.policy.${one.code}")
                    }
                }
            }
        }
        button { +texts.say("rules.save") }
    }
}

private fun FORM.rule(
    texts: PageTexts,
    field: RuleField,
    type: InputType,
    held: String,
    typed: Parameters?,
) = label {
    span { +texts.say("rules.${field.code}") }
    input(type, name = field.code) {
        value = typed?.get(field.code) ?: held
        if (type == InputType.dateTimeLocal) step = "1"
        attributes["autocomplete"] = "off"
    }
}

/** Extensions that were given, each to take back, and the form for one more. */
internal fun FlowContent.extensionForms(
    texts: PageTexts,
    address: String,
    students: List<Enrolled>,
    given: List<Extension>,
    held: ExerciseRules,
    typed: Parameters?,
) = section("card apart") {
    h2 { +texts.say("rules.extensions") }
    if (given.isEmpty()) p { +texts.say("rules.extensions.none") }
    ul {
        given.forEach { one ->
            li {
                +"${one.name}: ${texts.time(one.due)} (${one.reason}) "
                form("$address/extensions", method = FormMethod.post) {
                    input(InputType.hidden, name = "student") { value = one.student }
                    button(classes = "plain") {
                        attributes["aria-label"] = "${texts.say("rules.take.back")}: ${one.name}"
                        +texts.say("rules.take.back")
                    }
                }
            }
        }
    }
    if (students.isEmpty()) return@section
    form("$address/extensions", method = FormMethod.post) {
        label {
            span { +texts.say("rules.student") }
            select {
                name = "student"
                students.forEach { one ->
                    option {
                        value = one.id
                        selected = one.id == typed?.get("student")
                        +one.shownName
                    }
                }
            }
        }
        label {
            span { +texts.say("rules.until", held.zone.named()) }
            input(InputType.dateTimeLocal, name = "until") {
                value = typed?.get("until").orEmpty()
                required = true
            }
        }
        label {
            span { +texts.say("rules.reason") }
            input(InputType.text, name = "reason") {
                value = typed?.get("reason").orEmpty()
                required = true
                attributes["autocomplete"] = "off"
            }
        }
        button { +texts.say("rules.extend") }
    }
}
