package rasterlab.grader.rules

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import java.time.Instant
import java.time.ZoneId

class ExerciseRulesTest {
    /** Clocks in Berlin go forward in the night after this deadline, so that its first late day has 23 hours. */
    private val rules =
        ExerciseRules(due = Instant.parse("2026-03-28T22:00:00Z"), zone = ZoneId.of("Europe/Berlin"), lateDays = 2)

    @ParameterizedTest(name = "what comes at {0} is told to be other than {1}, or takes another late day than {2}")
    @CsvSource(
        "2026-03-28T22:00:00.000Z, IN_TIME, 0",
        "2026-03-28T22:00:00.001Z, LATE_DAY, 1",
        "2026-03-29T21:00:00.000Z, LATE_DAY, 1",
        "2026-03-29T21:00:00.001Z, LATE_DAY, 2",
        "2026-03-30T21:00:00.000Z, LATE_DAY, 2",
        "2026-03-30T21:00:00.001Z, PRACTICE, 0",
    )
    fun countsLateDaysInTheZone(
        at: Instant,
        arrival: Arrival,
        day: Int,
    ) {
        assertEquals(arrival, rules.arrival(at))
        assertEquals(day, rules.lateDay(at))
    }

    @ParameterizedTest(name = "{0} late days, {1} % a day: what comes at {2} is not {3}, or costs other than {4} %")
    @CsvSource(
        "2, 40, 2026-03-28T22:00:00.000Z, IN_TIME, 0",
        "2, 40, 2026-03-30T21:00:00.000Z, LATE_DAY, 0",
        "2, 40, 2026-03-30T21:00:00.001Z, LATE, 40",
        "2, 40, 2026-03-31T21:00:00.000Z, LATE, 40",
        "2, 40, 2026-03-31T21:00:00.001Z, LATE, 80",
        "2, 40, 2026-04-01T21:00:00.000Z, LATE, 80",
        "2, 40, 2026-04-01T21:00:00.001Z, PRACTICE, 0",
        "-1, 10, 2026-03-29T21:00:00.000Z, LATE, 10",
        "-1, 10, 2026-03-29T21:00:00.001Z, LATE, 20",
        "0, 50, 2026-03-29T21:00:00.001Z, PRACTICE, 0",
        "1, 100, 2026-03-29T21:00:00.000Z, LATE_DAY, 0",
        "1, 100, 2026-03-29T21:00:00.001Z, PRACTICE, 0",
    )
    fun chargesDaysBegunAfterTheLateDays(
        days: Int,
        percent: Int,
        at: Instant,
        arrival: Arrival,
        penalty: Int,
    ) {
        val ruled = rules.copy(lateDays = days.takeIf { it >= 0 }, latePenalty = percent)
        assertEquals(arrival to penalty, ruled.arrival(at) to ruled.penalty(at))
        assertEquals(0, ruled.copy(due = null).penalty(Instant.MAX))
    }

    @ParameterizedTest(name = "with {0} late days, what comes a day late is other than {1}")
    @CsvSource("-1, LATE", "0, PRACTICE", "1, LATE_DAY")
    fun tellsWhatALateDayIsWorth(
        days: Int,
        arrival: Arrival,
    ) {
        val ruled = rules.copy(lateDays = days.takeIf { it >= 0 })
        assertEquals(arrival, ruled.arrival(Instant.parse("2026-03-29T20:00:00Z")))
        assertEquals(Arrival.IN_TIME, ruled.copy(due = null).arrival(Instant.MAX))
    }
}
