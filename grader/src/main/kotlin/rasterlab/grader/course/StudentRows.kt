package rasterlab.grader.course

import org.jdbi.v3.core.Handle
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.time.Instant

/** Writes the students of one course, in the transaction of [handle]. */
internal class StudentRows(
    private val handle: Handle,
    private val course: String,
    private val now: Instant,
) {
    /** The id of a new student. */
    fun add(
        name: Name,
        token: String,
    ): String {
        val student = Secrets.newId()
        val number =
            handle
                .createQuery("SELECT coalesce(max(number), 0) + 1 FROM students WHERE course_id = :course")
                .bind("course", course)
                .mapTo(Int::class.javaObjectType)
                .one()
        handle
            .createUpdate(ADD)
            .bind("id", student)
            .bind("course", course)
            .bind("number", number)
            .bind("name", name.text)
            .bind("shown", shownName(name, number))
            .bind("hash", Secrets.hash(token))
            .bind("now", now.text())
            .execute()
        return student
    }

    /** The student keeps id and number. */
    fun rename(
        student: String,
        number: Int,
        name: Name,
    ) {
        handle
            .createUpdate(RENAME)
            .bind("id", student)
            .bind("name", name.text)
            .bind("shown", shownName(name, number))
            .execute()
    }

    /** Puts what a roster says of a student in the place of what one said before. */
    fun note(
        student: String,
        fields: Map<String, String>,
    ) {
        for ((kind, value) in fields) {
            handle
                .createUpdate(NOTE)
                .bind("student", student)
                .bind("kind", kind)
                .bind("value", value)
                .execute()
        }
    }

    private fun shownName(
        name: Name,
        number: Int,
    ): String {
        val taken =
            handle
                .createQuery(
                    """SELECT count(*) FROM students
                       WHERE course_id = :course AND shown_name = :name AND number <> :number""",
                ).bind("course", course)
                .bind("name", name.text)
                .bind("number", number)
                .mapTo(Int::class.javaObjectType)
                .one() > 0
        return shown(name, number, taken)
    }

    companion object {
        const val ADD =
            """INSERT INTO students (id, course_id, number, name, shown_name, token_hash, joined_at)
               VALUES (:id, :course, :number, :name, :shown, :hash, :now)"""
        const val RENAME = "UPDATE students SET name = :name, shown_name = :shown WHERE id = :id"
        const val NOTE =
            """INSERT INTO roster_fields (student_id, kind, value) VALUES (:student, :kind, :value)
               ON CONFLICT (student_id, kind) DO UPDATE SET value = excluded.value"""

        /**
         * No two are shown under one name, and a name that ends like one with a number is not mistaken for one.
         *
         * @param taken whether another student of the course is shown as [name]
         */
        fun shown(
            name: Name,
            number: Int,
            taken: Boolean,
        ): String = if (taken || name.text.endsWith(")")) "${name.text} ($number)" else name.text
    }
}
