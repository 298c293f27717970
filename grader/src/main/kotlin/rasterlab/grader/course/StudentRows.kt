package rasterlab.grader.course

import org.jdbi.v3.core.Handle
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.time.Instant

/**
 * Writes the students of one course, in the transaction of [handle]; nobody else comes while it lasts. Nothing is written
 * before [write], which takes one batch for each kind of row, since others wait for the one writer meanwhile.
 */
internal class StudentRows(
    private val handle: Handle,
    private val course: String,
    private val now: Instant,
) {
    private val names by lazy { ShownNames(shownBefore()) }
    private val before by lazy(::lastNumber)
    private val added = handle.prepareBatch(ADD)
    private val renamed = handle.prepareBatch(RENAME)
    private val noted = handle.prepareBatch(NOTE)

    /** The id of a new student. */
    fun add(
        name: Name,
        token: String,
    ): String {
        val student = Secrets.newId()
        val number = before + added.size() + 1
        added
            .bind("id", student)
            .bind("course", course)
            .bind("number", number)
            .bind("name", name.text)
            .bind("shown", names.give(number, name))
            .bind("hash", Secrets.hash(token))
            .bind("now", now.text())
            .add()
        return student
    }

    /** The student keeps id and number. */
    fun rename(
        student: String,
        number: Int,
        name: Name,
    ) {
        renamed
            .bind("id", student)
            .bind("name", name.text)
            .bind("shown", names.give(number, name))
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

    fun write() {
        if (added.size() > 0) {
            handle
                .createUpdate("UPDATE courses SET last_number = :last WHERE id = :course")
                .bind("last", before + added.size())
                .bind("course", course)
                .execute()
        }
        listOf(renamed, added, noted).filter { it.size() > 0 }.forEach { it.execute() }
    }

    private fun lastNumber(): Int =
        handle
            .createQuery("SELECT last_number FROM courses WHERE id = :course")
            .bind("course", course)
            .mapTo(Int::class.javaObjectType)
            .one()

    private fun shownBefore(): Map<Int, String> =
        handle
            .createQuery("SELECT number, shown_name FROM students WHERE course_id = :course")
            .bind("course", course)
            .map { row, _ -> row.getInt("number") to row.getString("shown_name") }
            .list()
            .toMap()

    private companion object {
        const val ADD =
            """INSERT INTO students (id, course_id, number, name, shown_name, token_hash, joined_at)
               VALUES (:id, :course, :number, :name, :shown, :hash, :now)"""
        const val RENAME = "UPDATE students SET name = :name, shown_name = :shown WHERE id = :id"
        const val NOTE =
            """INSERT INTO roster_fields (student_id, kind, value) VALUES (:student, :kind, :value)
               ON CONFLICT (student_id, kind) DO UPDATE SET value = excluded.value"""
    }
}
