package rasterlab.grader.course

import org.jdbi.v3.core.Handle
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Secrets
import java.time.InstantSource

/** @param token that lets the student in, told this once; null in a preview */
data class RosterAddition(
    val student: String?,
    val name: String,
    val token: String?,
)

/** A student of whom the roster says something new. */
data class RosterCorrection(
    val student: String,
    val from: String,
    val to: String,
    val fields: List<String>,
)

/**
 * Tells what a roster changes, or would change.
 *
 * @param missing students of the course who are not in the roster; they stay
 */
data class RosterChange(
    val added: List<RosterAddition>,
    val corrected: List<RosterCorrection>,
    val unchanged: Int,
    val missing: List<Enrolled>,
)

/**
 * Brings a course's students to what a roster says. A student is known again by what only one has, such as an address,
 * or else by the name; nobody is taken out.
 */
class RosterImport(
    private val database: Database,
    private val clock: InstantSource,
) {
    /**
     * Applies a roster, or with [dry] says only what would change.
     *
     * @param by who does it, for the audit
     */
    fun apply(
        course: Course,
        roster: ByteArray,
        dry: Boolean,
        by: String,
    ): RosterChange {
        val rows = Roster.read(roster)
        if (dry) return database.read { plan(it, course, rows).change(null) }
        return database.write { handle ->
            val change = plan(handle, course, rows).change(StudentRows(handle, course.id, clock.instant()))
            val detail = "added ${change.added.size}, corrected ${change.corrected.size}"
            AuditNote(by, course.id, "roster", subject = "", detail).write(handle, clock.instant())
            change
        }
    }

    private fun plan(
        handle: Handle,
        course: Course,
        rows: List<RosterRow>,
    ): Plan {
        val students = Courses.enrolled(handle, course.id)
        val fields = Courses.rosterFields(handle, course.id)
        val byKey =
            students
                .flatMap { student -> fields[student.id].orEmpty().map { (it.key to it.value.lowercase()) to student } }
                .toMap()
        val named = students.groupBy { it.name }
        val matches = LinkedHashMap<RosterRow, Enrolled>()
        val taken = HashMap<String, RosterRow>()
        for (row in rows) {
            val found =
                row.keys.firstNotNullOfOrNull { byKey[it.first to it.second.lowercase()] }
                    ?: byName(row, named[row.name.text].orEmpty(), fields)
                    ?: continue
            taken.put(found.id, row)?.let { throw Rejection.BadRoster("both", it.line, row.line, found.shownName) }
            matches[row] = found
        }
        return Plan(rows, matches, fields, students.filter { it.id !in taken })
    }

    /** The student of that name, unless a roster said before that this is somebody else. */
    private fun byName(
        row: RosterRow,
        candidates: List<Enrolled>,
        fields: Map<String, Map<String, String>>,
    ): Enrolled? {
        val possible = candidates.filter { one -> row.keys.none { (kind, _) -> kind in fields[one.id].orEmpty() } }
        if (possible.size > 1) throw Rejection.BadRoster("ambiguous", row.line, row.name.text)
        return possible.singleOrNull()
    }

    private class Plan(
        val rows: List<RosterRow>,
        val matches: Map<RosterRow, Enrolled>,
        val fields: Map<String, Map<String, String>>,
        val missing: List<Enrolled>,
    ) {
        /** @param students what writes it, or null for a preview */
        fun change(students: StudentRows?): RosterChange {
            val corrected = matches.mapNotNull { (row, student) -> correction(row, student, students) }
            val added = rows.filter { it !in matches }.map { addition(it, students) }
            return RosterChange(added, corrected, matches.size - corrected.size, missing)
        }

        private fun correction(
            row: RosterRow,
            student: Enrolled,
            students: StudentRows?,
        ): RosterCorrection? {
            val before = fields[student.id].orEmpty()
            val news = row.fields.filter { (kind, value) -> before[kind] != value }
            val renamed = row.name.text != student.name
            if (news.isEmpty() && !renamed) return null
            if (renamed) students?.rename(student.id, student.number, row.name)
            students?.note(student.id, news)
            return RosterCorrection(student.id, student.name, row.name.text, news.keys.toList())
        }

        private fun addition(
            row: RosterRow,
            students: StudentRows?,
        ): RosterAddition {
            if (students == null) return RosterAddition(null, row.name.text, null)
            val token = Secrets.newToken()
            val student = students.add(row.name, token)
            students.note(student, row.fields)
            return RosterAddition(student, row.name.text, token)
        }
    }
}
