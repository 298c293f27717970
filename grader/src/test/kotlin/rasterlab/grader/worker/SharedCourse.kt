package rasterlab.grader.worker

import org.junit.jupiter.api.Assertions.assertEquals
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.grader.ClassOfStudents
import rasterlab.grader.course.Identity
import rasterlab.grader.postgres.TestDatabases
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.PostgresAddress
import rasterlab.grader.submission.Leases
import rasterlab.grader.submission.SteadyClock
import java.nio.file.Path
import java.sql.Connection
import java.time.InstantSource
import java.util.concurrent.TimeUnit.MINUTES
import java.util.concurrent.locks.LockSupport
import kotlin.io.path.readText

/** A course in a database of its own, whose students hand in a starter; processes that the test starts grade it. */
class SharedCourse(
    private val folder: Path,
    name: String,
) : AutoCloseable {
    val address = checkNotNull(TestDatabases.server).address(name)
    val database = Database.open(checkNotNull(PostgresAddress.of(address)), folder, null)
    val workers = Workers(database, SteadyClock(InstantSource.system()), Leases.LENGTH)
    private val exercise = Catalogue.builtIn().all().first { it.id() == "window-segment" }
    private val students = ClassOfStudents(database, InstantSource.system(), exercise)
    private val processes = mutableListOf<GraderProcess>()

    fun student(name: String): Identity.StudentIdentity = students.student(name)

    fun handIn(student: Identity.StudentIdentity): String = students.handIn(student, exercise.starter())

    /** Hands in what is stopped in each case after some seconds, and so takes much longer to grade than to start. */
    fun handInEndless(student: Identity.StudentIdentity): String =
        students.handIn(student, exercise.starter().replace("out) {}", "out) { while (true) if (x0 > 1e9) break; }"))

    /** @param through the address of the database as the worker has it */
    fun worker(
        name: String,
        vararg more: String,
        through: String = address,
    ): GraderProcess {
        val data = folder.resolve("of-$name")
        return start("worker", "--db", through, "--data", "$data", "--name", name, *IMAGES, *more).also {
            assertEquals(name, it.line("grading as "))
        }
    }

    fun server(name: String): GraderProcess =
        start(
            "serve",
            "--db",
            address,
            "--data",
            "${folder.resolve("of-$name")}",
            "--name",
            name,
            "--port",
            "0",
            *IMAGES,
        ).also { it.line("listening on ") }

    fun start(vararg arguments: String): GraderProcess = GraderProcess.start(*arguments).also { processes += it }

    /** Waits until [holds], and fails after some minutes with what there is instead. */
    fun await(
        what: String,
        holds: () -> Boolean,
    ) {
        val end = System.nanoTime() + MINUTES.toNanos(PATIENCE_MINUTES)
        while (!holds()) {
            check(System.nanoTime() < end) { "$what, but there are ${rows(STANDS)}" }
            LockSupport.parkNanos(LOOK_NANOS)
        }
    }

    fun awaitAllDone() =
        await("expected all to be graded") {
            rows("SELECT id FROM submissions WHERE state <> 'done'").isEmpty()
        }

    /** The submissions that the process of that name grades now. */
    fun heldBy(name: String): List<String> = rows("SELECT id FROM submissions WHERE lease LIKE '$name %'")

    fun rows(select: String): List<String> = database.read { it.createQuery(select).mapTo(String::class.java).list() }

    /** Makes a connection to the database beside those of [database]. */
    fun connection(): Connection = checkNotNull(PostgresAddress.of(address)).source(0).connection

    /** Reads the log of the worker of that name. */
    fun logOf(name: String): String = folder.resolve("of-$name/server.log").readText()

    /** Lets all leases run out that a process of that name has. */
    fun expire(name: String) {
        database.write {
            it.execute("UPDATE submissions SET lease_until = '2000-01-01T00:00:00.000Z' WHERE lease LIKE '$name %'")
        }
    }

    /** Each submission has one result, and they are equal but for what was measured. */
    fun requireEachOnce() {
        assertEquals(listOf("1"), rows(RESULTS_OF_EACH))
        val results =
            rows("SELECT DISTINCT verdict || ' ' || accuracy || ' ' || stability || ' ' || isolation FROM results")
        assertEquals(1, results.size, "$results")
    }

    override fun close() {
        processes.forEach(GraderProcess::close)
        database.close()
    }

    private companion object {
        /** All processes of the tests share the images of Java, as each takes seconds to make. */
        val IMAGES = arrayOf("--java-images", "${Path.of("target", "java-images").toAbsolutePath()}")
        const val PATIENCE_MINUTES = 4L

        /** The time between two looks, in which what is waited for has the processor. */
        const val LOOK_NANOS = 20_000_000L

        const val RESULTS_OF_EACH =
            """SELECT DISTINCT count(r.id) FROM submissions s LEFT JOIN results r ON r.submission_id = s.id
               GROUP BY s.id"""
        const val STANDS =
            "SELECT state || ' ' || coalesce(lease, '-') || ' ' || tries FROM submissions ORDER BY sequence"
    }
}
