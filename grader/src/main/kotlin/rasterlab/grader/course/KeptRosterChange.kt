package rasterlab.grader.course

import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json

/**
 * A correction as it is kept.
 *
 * @param line of the roster that asks for it
 * @param before what was said of each changed field; null where nothing was
 */
@Serializable
internal data class KeptCorrection(
    val student: String,
    val line: Int,
    val from: String,
    val before: Map<String, String?>,
)

/**
 * A change as it is kept, so that the same roster sent again is answered in the same way; the rest stands in the
 * roster.
 *
 * @param added ids of those who came, by the line of the roster
 * @param missing ids of those who are not in the roster
 */
@Serializable
internal data class KeptRosterChange(
    val added: Map<Int, String>,
    val corrected: List<KeptCorrection>,
    val unchanged: Int,
    val missing: List<String>,
) {
    fun text(): String = Json.encodeToString(this)

    /**
     * The change once more.
     *
     * @param students of the course as they are now
     * @param token of the student whom a line brought
     */
    fun again(
        table: RosterTable,
        students: List<Enrolled>,
        token: (RosterRow) -> String,
    ): RosterChange {
        val rows = table.rows.associateBy { it.line }
        val byId = students.associateBy { it.id }
        return RosterChange(
            added.map { (line, student) ->
                val row = rows.getValue(line)
                RosterAddition(student, row.name.text, token(row), row.fields)
            },
            corrected.map { one ->
                val row = rows.getValue(one.line)
                val changes = one.before.map { (field, old) -> FieldChange(field, old, row.fields.getValue(field)) }
                val known = byId[one.student]?.fields.orEmpty()
                RosterCorrection(one.student, one.from, row.name.text, changes, known)
            },
            unchanged,
            missing.mapNotNull(byId::get),
            table.unused,
        )
    }

    companion object {
        fun of(text: String): KeptRosterChange = Json.decodeFromString(text)

        /** @param lines of the roster, by the id of the student whom each is about */
        fun of(
            change: RosterChange,
            lines: Map<String, Int>,
        ) = KeptRosterChange(
            change.added.mapNotNull { it.student }.associateBy(lines::getValue),
            change.corrected.map { one ->
                val before = one.changes.associate { it.field to it.from }
                KeptCorrection(one.student, lines.getValue(one.student), one.from, before)
            },
            change.unchanged,
            change.missing.map { it.id },
        )
    }
}
