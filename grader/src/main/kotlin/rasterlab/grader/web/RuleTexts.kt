package rasterlab.grader.web

import rasterlab.grader.rules.Arrival
import rasterlab.grader.rules.ExerciseRules
import java.time.Instant

/** Tells what the rules of an exercise mean to a student at this moment, a sentence or two each. */
internal fun PageTexts.rules(
    rules: ExerciseRules,
    now: Instant,
    made: Int,
): List<String> =
    listOfNotNull(
        rules.opens?.takeIf { now < it }?.let { say("exercise.opens", time(it)) },
        rules.due?.let { deadline(rules, it, now) },
        rules.attempts?.let { say("exercise.attempts", made, it) },
        say(
            "exercise.policy.${rules.policy.code}",
        ).takeIf { rules != ExerciseRules(due = rules.due, zone = rules.zone) },
        rules.latePenalty.takeIf { it > 0 && rules.due != null && rules.arrival(now) != Arrival.PRACTICE }?.let {
            say("exercise.penalty", it, rules.freeDays ?: 0, rules.closes?.let(::time).orEmpty())
        },
    )

private fun PageTexts.deadline(
    rules: ExerciseRules,
    due: Instant,
    now: Instant,
): String {
    val told = time(due)
    val free = rules.free?.let(::time).orEmpty()
    return when (rules.arrival(now)) {
        Arrival.IN_TIME -> {
            when (val days = rules.lateDays) {
                null -> say("exercise.due", told)
                0 -> say(if (rules.latePenalty > 0) "exercise.due" else "exercise.due.strict", told)
                else -> say("exercise.due.days", told, days, free)
            }
        }

        Arrival.LATE -> {
            if (rules.latePenalty > 0) {
                say("exercise.over.cost", told, rules.penalty(now))
            } else {
                say("exercise.over", told)
            }
        }

        Arrival.LATE_DAY -> {
            say("exercise.over.day", told, free, rules.lateDay(now), rules.lateDays ?: 0)
        }

        Arrival.PRACTICE -> {
            say("exercise.over.practice", told)
        }
    }
}

/** Tells what a student agrees to who hands in at this moment; null where it is in time. */
internal fun PageTexts.consent(
    rules: ExerciseRules,
    now: Instant,
): String? =
    when (rules.arrival(now)) {
        Arrival.IN_TIME -> null
        Arrival.LATE -> rules.penalty(now).let { if (it > 0) say("exercise.late.cost", it) else say("exercise.late") }
        Arrival.LATE_DAY -> say("exercise.late.day", rules.lateDay(now), rules.lateDays ?: 0)
        Arrival.PRACTICE -> say("exercise.late.practice")
    }
