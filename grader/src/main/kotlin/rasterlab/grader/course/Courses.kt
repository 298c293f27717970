package rasterlab.grader.course

import org.jdbi.v3.core.Handle
import org.jdbi.v3.core.statement.Query
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.time.Instant
import java.time.InstantSource
import java.util.Locale
import kotlin.jvm.optionals.getOrNull

/** @param code what students join with */
data class Course(
    val id: String,
    val name: String,
    val code: String,
)

/** @param token shown this once */
data class NewStudent(
    val id: String,
    val token: String,
)

/** A student of a course. */
data class Enrolled(
    val id: String,
    val name: String,
    val joinedAt: Instant,
)

/** Courses and who is in them. */
class Courses(
    private val database: Database,
    private val clock: InstantSource,
) {
    fun create(
        by: Identity.Instructor,
        name: Name,
        key: String?,
    ): Course {
        val request = Repeatable("courses ${by.id}", key, name.text)
        return database.write { handle ->
            request.made(handle)?.let { course(handle, "id", it) } ?: insert(handle, name, request)
        }
    }

    fun all(): List<Course> = database.read { rows(select(it, "")).list() }

    /**
     * A new student of the course with this code.
     *
     * A repeated request gets the same token again although only its hash is stored: with a key, the
     * token is derived from the key and a secret of this server.
     */
    fun join(
        code: String,
        name: Name,
        key: String?,
    ): NewStudent =
        database.write { handle ->
            val course =
                course(handle, "code", code.trim().uppercase(Locale.ROOT)) ?: throw Rejection.UnknownCourse(code)
            val request = Repeatable("join ${course.id}", key, name.text)
            val token =
                when (key) {
                    null -> Secrets.newToken()
                    else -> Secrets.derive(handle, "join ${course.id} $key ${name.text}")
                }
            val student =
                request.made(handle)
                    ?: enrol(handle, course, name, token).also { request.remember(handle, it, clock.instant()) }
            NewStudent(student, token)
        }

    /** The students of a course in the order of their names, or null where there is no such course. */
    fun students(course: String): List<Enrolled>? =
        database.read { handle ->
            course(handle, "id", course) ?: return@read null
            handle
                .createQuery(
                    "SELECT id, name, joined_at FROM students WHERE course_id = :course ORDER BY name, joined_at",
                ).bind("course", course)
                .map { row, _ ->
                    Enrolled(row.getString("id"), row.getString("name"), Instant.parse(row.getString("joined_at")))
                }.list()
        }

    private fun insert(
        handle: Handle,
        name: Name,
        request: Repeatable,
    ): Course {
        val course = Course(Secrets.newId(), name.text, Secrets.newCode(CODE_LENGTH))
        handle
            .createUpdate("INSERT INTO courses (id, name, code, created_at) VALUES (:id, :name, :code, :now)")
            .bind("id", course.id)
            .bind("name", course.name)
            .bind("code", course.code)
            .bind("now", clock.instant().text())
            .execute()
        request.remember(handle, course.id, clock.instant())
        return course
    }

    private fun enrol(
        handle: Handle,
        course: Course,
        name: Name,
        token: String,
    ): String {
        val student = Secrets.newId()
        handle
            .createUpdate(
                "INSERT INTO students (id, course_id, name, token_hash, joined_at) VALUES (:id, :course, :name, :hash, :now)",
            ).bind("id", student)
            .bind("course", course.id)
            .bind("name", name.text)
            .bind("hash", Secrets.hash(token))
            .bind("now", clock.instant().text())
            .execute()
        return student
    }

    private fun course(
        handle: Handle,
        column: String,
        value: String,
    ): Course? = rows(select(handle, "WHERE $column = :value").bind("value", value)).findOne().getOrNull()

    private fun select(
        handle: Handle,
        condition: String,
    ): Query = handle.createQuery("SELECT id, name, code FROM courses $condition ORDER BY created_at DESC")

    private fun rows(query: Query) =
        query.map { row, _ -> Course(row.getString("id"), row.getString("name"), row.getString("code")) }

    private companion object {
        /** 40 bits, and guesses are counted. */
        const val CODE_LENGTH = 8
    }
}
