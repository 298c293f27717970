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

/**
 * A course as staff see it in a list.
 *
 * @param students how many are in it
 */
data class CourseOverview(
    val course: Course,
    val madeAt: Instant,
    val students: Int,
)

/** @param token shown this once */
data class NewStudent(
    val id: String,
    val token: String,
)

/**
 * A student of a course.
 *
 * @param number from 1 in the order of joining; it stays theirs
 * @param shownName the name, or where another has it the name with the number
 * @param fields what rosters said besides the name, by [RosterColumn.kind]
 */
data class Enrolled(
    val id: String,
    val number: Int,
    val name: String,
    val shownName: String,
    val joinedAt: Instant,
    val fields: Map<String, String>,
)

/** Courses and who is in them. */
class Courses(
    private val database: Database,
    private val clock: InstantSource,
) {
    /**
     * Makes a course in which nobody is yet.
     *
     * @param by who does it, for the audit
     * @param key what the sender calls this request, so that repeating it makes no other course
     */
    fun create(
        by: String,
        name: Name,
        key: String?,
    ): Course {
        val request = Repeatable("courses $by", key, name.text)
        return database.write { handle ->
            request.made(handle)?.let { course(handle, "id", it) }
                ?: insert(handle, name, clock.instant()).also {
                    AuditNote(by, it.id, "course", it.id, name.text).write(handle, clock.instant())
                    request.remember(handle, it.id, clock.instant())
                }
        }
    }

    fun all(): List<Course> = database.read { rows(select(it, "")).list() }

    /** The courses that somebody teaches. */
    fun of(who: Identity.StaffIdentity): List<Course> = all().filter { who.teaches(it.id) }

    /** Looks at the courses that somebody teaches, the latest first. */
    fun overviews(who: Identity.StaffIdentity): List<CourseOverview> =
        database.read { overviews(it, "") }.filter { who.teaches(it.course.id) }

    /** Looks at the course of that id; null where there is none. */
    fun overview(course: String): CourseOverview? =
        database.read { overviews(it, "WHERE id = :course", "course" to course) }.singleOrNull()

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
                    ?: StudentRows(handle, course.id, clock.instant())
                        .run { add(name, token).also { write() } }
                        .also { request.remember(handle, it, clock.instant()) }
            NewStudent(student, token)
        }

    /** The students of a course in the order of their names, or null where there is no such course. */
    fun students(course: String): List<Enrolled>? =
        database.read { handle ->
            course(handle, "id", course) ?: return@read null
            enrolled(handle, course)
        }

    /** @throws Rejection.UnknownStudent where the course has none of that id */
    fun student(
        course: String,
        id: String,
    ): Enrolled =
        database.read { handle ->
            enrolled(handle, course, "AND id = :id", "id" to id).singleOrNull() ?: throw Rejection.UnknownStudent(id)
        }

    /** The course with that id or that code, or null. */
    fun find(idOrCode: String): Course? = database.read { find(it, idOrCode) }

    /** The course of a student, or null where there is no such student. */
    fun ofStudent(student: String): Course? =
        database.read { handle ->
            val query = select(handle, "WHERE id = (SELECT course_id FROM students WHERE id = :student)")
            rows(query.bind("student", student)).findOne().getOrNull()
        }

    internal companion object {
        /** 40 bits, and guesses are counted. */
        private const val CODE_LENGTH = 8

        /** A new course, with a code of its own. */
        fun insert(
            handle: Handle,
            name: Name,
            now: Instant,
        ): Course {
            val course = Course(Secrets.newId(), name.text, Secrets.newCode(CODE_LENGTH))
            handle
                .createUpdate("INSERT INTO courses (id, name, code, created_at) VALUES (:id, :name, :code, :now)")
                .bind("id", course.id)
                .bind("name", course.name)
                .bind("code", course.code)
                .bind("now", now.text())
                .execute()
            return course
        }

        fun course(
            handle: Handle,
            column: String,
            value: String,
        ): Course? = rows(select(handle, "WHERE $column = :value").bind("value", value)).findOne().getOrNull()

        private fun find(
            handle: Handle,
            idOrCode: String,
        ): Course? = course(handle, "id", idOrCode) ?: course(handle, "code", idOrCode.trim().uppercase(Locale.ROOT))

        /** @throws Rejection.UnknownCourse where none has that id or code */
        fun named(
            handle: Handle,
            idOrCode: String,
        ): Course = find(handle, idOrCode) ?: throw Rejection.UnknownCourse(idOrCode)

        private fun select(
            handle: Handle,
            condition: String,
        ): Query = handle.createQuery("SELECT id, name, code FROM courses $condition ORDER BY created_at DESC")

        private fun overviews(
            handle: Handle,
            condition: String,
            vararg values: Pair<String, String>,
        ): List<CourseOverview> =
            handle
                .createQuery(
                    """SELECT id, name, code, created_at,
                           (SELECT count(*) FROM students WHERE course_id = courses.id) AS enrolled
                       FROM courses $condition ORDER BY created_at DESC, id""",
                ).bindMap(values.toMap())
                .map { row, _ ->
                    val course = Course(row.getString("id"), row.getString("name"), row.getString("code"))
                    CourseOverview(course, Instant.parse(row.getString("created_at")), row.getInt("enrolled"))
                }.list()

        private fun rows(query: Query) =
            query.map { row, _ -> Course(row.getString("id"), row.getString("name"), row.getString("code")) }

        /**
         * The students of a course in the order of their names.
         *
         * @param condition which of them, with the names of [values] in it
         */
        fun enrolled(
            handle: Handle,
            course: String,
            condition: String = "",
            vararg values: Pair<String, String>,
        ): List<Enrolled> {
            val fields = rosterFields(handle, course, condition, values.toMap())
            return handle
                .createQuery(
                    """SELECT id, number, name, shown_name, joined_at FROM students
                       WHERE course_id = :course $condition ORDER BY name, number""",
                ).bind("course", course)
                .bindMap(values.toMap())
                .map { row, _ ->
                    Enrolled(
                        row.getString("id"),
                        row.getInt("number"),
                        row.getString("name"),
                        row.getString("shown_name"),
                        Instant.parse(row.getString("joined_at")),
                        fields[row.getString("id")].orEmpty(),
                    )
                }.list()
        }

        /** Reads what rosters said of these students of a course, by the student's id. */
        private fun rosterFields(
            handle: Handle,
            course: String,
            condition: String,
            values: Map<String, String>,
        ): Map<String, Map<String, String>> =
            handle
                .createQuery(
                    """SELECT student_id, kind, value FROM roster_fields JOIN students ON students.id = student_id
                       WHERE course_id = :course $condition""",
                ).bind("course", course)
                .bindMap(values)
                .map { row, _ -> Triple(row.getString("student_id"), row.getString("kind"), row.getString("value")) }
                .list()
                .groupBy({ it.first }, { it.second to it.third })
                .mapValues { it.value.toMap() }
    }
}
