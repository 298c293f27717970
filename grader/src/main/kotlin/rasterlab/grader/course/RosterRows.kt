package rasterlab.grader.course

import org.jdbi.v3.core.Handle
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.time.Instant

/**
 * Writes what a roster changes, in the transaction of [handle]: each kind of row with one batch, since others wait for
 * the one writer meanwhile.
 *
 * @param before the students of the course; nobody else comes while the transaction lasts
 */
internal class RosterRows(
    private val handle: Handle,
    private val course: String,
    before: List<Enrolled>,
    private val now: Instant,
) {
    private val shown = before.associateTo(HashMap()) { it.shownName to it.number }
    private var last = before.maxOfOrNull { it.number } ?: 0
    private val added = handle.prepareBatch(StudentRows.ADD)
    private val renamed = handle.prepareBatch(StudentRows.RENAME)
    private val noted = handle.prepareBatch(StudentRows.NOTE)

    /** The id of a new student. */
    fun add(
        name: Name,
        token: String,
    ): String {
        val student = Secrets.newId()
        last++
        added
            .bind("id", student)
            .bind("course", course)
            .bind("number", last)
            .bind("name", name.text)
            .bind("shown", take(name, last))
            .bind("hash", Secrets.hash(token))
            .bind("now", now.text())
            .add()
        return student
    }

    /** The student keeps id and number. */
    fun rename(
        student: Enrolled,
        name: Name,
    ) {
        shown.remove(student.shownName)
        renamed
            .bind("id", student.id)
            .bind("name", name.text)
            .bind("shown", take(name, student.number))
            .add()
    }

    /** Puts what a roster says of a student in the place of what one said before. */
    fun note(
        student: String,
        fields: Map<String, String>,
    ) {
        for ((kind, value) in fields) {
            noted
                .bind("student", student)
                .bind("kind", kind)
                .bind("value", value)
                .add()
        }
    }

    fun write() = listOf(renamed, added, noted).filter { it.size() > 0 }.forEach { it.execute() }

    private fun take(
        name: Name,
        number: Int,
    ): String {
        val holder = shown[name.text]
        return StudentRows.shown(name, number, holder != null && holder != number).also { shown[it] = number }
    }
}
