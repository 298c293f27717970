/*
 * Grading again what was graded before: all of an exercise or some, tried first or at once, and undone.
 * Read Regrades, then RegradeChanges. The work itself is done in submission, by RegradeLeases.
 */
package rasterlab.grader.regrade

import org.jdbi.v3.core.Handle
import org.jdbi.v3.core.statement.Query
import rasterlab.exercises.Exercise
import rasterlab.grader.course.AuditNote
import rasterlab.grader.course.Course
import rasterlab.grader.problem.ListPart
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import rasterlab.grader.submission.RegradedResults
import java.sql.ResultSet
import java.time.Instant
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

enum class RegradeState {
    GRADING,
    GRADED,
    ACCEPTED,
    DISCARDED,
    UNDONE,
    ;

    /** Lower-case, as stored and in the HTTP API. */
    val code get() = name.lowercase()
}

/**
 * A regrade and how far it has come.
 *
 * @param revision of the exercise that all of it is graded against
 * @param case name of the only case whose result it replaces; null where it replaces whole results
 * @param dry whether its results wait for a decision
 * @param done how many of the [total] submissions are graded
 * @param failed how many of these got no result by a fault of ours, and keep their earlier one
 */
data class Regrade(
    val id: String,
    val course: String,
    val exercise: String,
    val revision: String,
    val choice: RegradeChoice,
    val case: String?,
    val dry: Boolean,
    val state: RegradeState,
    val begunAt: Instant,
    val settledAt: Instant?,
    val total: Int,
    val done: Int,
    val failed: Int,
)

/** Starts regrades and decides on them. */
class Regrades(
    private val database: Database,
    private val clock: InstantSource,
) {
    /**
     * Puts submissions into the queue to be graded again, behind all that are handed in; those that wait for their first
     * result are left out.
     *
     * @param some ids of submissions, where these are chosen one by one
     * @param dry whether nothing counts until it is accepted
     * @param by who does it, for the audit
     * @param key what the sender calls this request, so that repeating it begins no other one
     * @param case the only one whose result is replaced, as [exercise] has it; null for whole results
     */
    fun start(
        course: Course,
        exercise: Exercise,
        choice: RegradeChoice,
        some: Collection<String>,
        dry: Boolean,
        by: String,
        key: String?,
        case: Exercise.Case? = null,
    ): Regrade {
        val only = case?.let { " ${it.name()}" }.orEmpty()
        val asked = "${course.id} ${exercise.id()} ${choice.code} $dry ${some.sorted()}$only"
        val request = Repeatable("regrade $by", key, asked)
        return database.write { handle ->
            val made =
                request.made(handle) ?: run {
                    val chosen = choice.of(Gradable.all(handle, course, exercise.id()), some)
                    requireFree(handle, chosen, case != null)
                    insert(handle, course, exercise, choice, case, dry, by).also { id ->
                        chosen.forEachIndexed { index, one -> insert(handle, id, one, index + 1) }
                        note(handle, course.id, by, "regrade", id, "${exercise.id()} ${choice.code} ${chosen.size}")
                        request.remember(handle, id, clock.instant())
                    }
                }
            checkNotNull(find(handle, made)) { "regrade $made was just stored" }
        }
    }

    /** @throws Rejection.UnknownRegrade */
    fun find(id: String): Regrade = database.read { named(it, id) }

    /**
     * Lists those of a course, the latest first.
     *
     * @throws Rejection.Malformed where the course has none of the id behind which the part begins
     */
    fun ofCourse(
        course: Course,
        paging: Paging = Paging(after = null, LISTED),
    ): ListPart<Regrade> =
        database.read { handle ->
            val last =
                paging.after?.let {
                    find(handle, it)?.takeIf { one -> one.course == course.id }
                        ?: throw paging.unknown()
                }
            val earlier = if (last == null) "" else "AND (begun_at, id) < (:seenAt, :seen)"
            val read =
                handle
                    .createQuery(
                        "$SELECT WHERE course_id = :course $earlier ORDER BY begun_at DESC, id DESC LIMIT :most",
                    ).bind("course", course.id)
                    .bind("most", paging.reach)
                    .apply { if (last != null) bind("seenAt", last.begunAt.text()).bind("seen", last.id) }
            paging.cut(rows(read)) { it.id }
        }

    /** Lists the submissions that can be graded again, in the order of handing in. */
    fun gradable(
        course: Course,
        exercise: String,
    ): List<Gradable> = database.read { Gradable.all(it, course, exercise) }

    /** Compares the results of a regrade with those that it replaced, or would. */
    fun changes(regrade: Regrade): List<RegradeChange> = database.read { RegradeChanges(it, regrade).all() }

    /** Lets the results of a dry run count. */
    fun accept(
        id: String,
        by: String,
        key: String? = null,
    ): Regrade =
        decide(id, by, key, "accept", RegradeState.GRADED) {
            RegradedResults.accept(it, id, clock.instant())
        }

    /** Ends a regrade whose results shall never count, also one that is still graded. */
    fun discard(
        id: String,
        by: String,
        key: String? = null,
    ): Regrade =
        decide(id, by, key, "discard", RegradeState.GRADING, RegradeState.GRADED) {
            it
                .createUpdate(
                    """UPDATE regrade_items SET state = 'done', lease = NULL, lease_until = NULL
                       WHERE regrade_id = :id AND state <> 'done'""",
                ).bind("id", id)
                .execute()
            RegradedResults.mark(it, id, RegradeState.DISCARDED.code, clock.instant())
        }

    /** Lets the earlier results count again. */
    fun undo(
        id: String,
        by: String,
        key: String? = null,
    ): Regrade =
        decide(id, by, key, "undo", RegradeState.ACCEPTED) {
            val replaced = RegradedResults.replaced(it, id)
            if (replaced > 0) throw Rejection.RegradeStands("later", replaced)
            RegradedResults.undo(it, id, clock.instant())
        }

    /** @param key what the sender calls this request, so that repeating it is answered as before */
    private fun decide(
        id: String,
        by: String,
        key: String?,
        action: String,
        vararg allowed: RegradeState,
        change: (Handle) -> Unit,
    ): Regrade {
        val request = Repeatable("regrade $by", key, "$action $id")
        return database.write { handle ->
            val regrade = named(handle, id)
            if (request.made(handle) != null) return@write regrade
            if (regrade.state !in allowed) throw Rejection.RegradeStands("$action.${regrade.state.code}")
            change(handle)
            note(handle, regrade.course, by, "regrade-$action", id, regrade.exercise)
            request.remember(handle, id, clock.instant())
            named(handle, id)
        }
    }

    /**
     * Sees that no submission is graded again twice at once, where one would take back what the other gives: results of
     * single cases are put into whatever counts when they come.
     */
    private fun requireFree(
        handle: Handle,
        chosen: List<Gradable>,
        isOfOneCase: Boolean,
    ) {
        val others = if (isOfOneCase) "AND case_name IS NULL" else ""
        val held =
            handle
                .createQuery(
                    """SELECT submission_id FROM regrade_items JOIN regrades ON regrades.id = regrade_id
                       WHERE regrade_items.state <> 'done' $others""",
                ).mapTo(String::class.java)
                .set()
        val twice = chosen.count { it.submission in held }
        if (twice > 0) throw Rejection.RegradeStands("running", twice)
    }

    private fun insert(
        handle: Handle,
        course: Course,
        exercise: Exercise,
        choice: RegradeChoice,
        case: Exercise.Case?,
        dry: Boolean,
        by: String,
    ): String {
        val id = Secrets.newId()
        handle
            .createUpdate(
                """INSERT INTO regrades (id, course_id, exercise, revision, choice, case_name, earns_stability, is_dry,
                       state, account_id, begun_at)
                   VALUES (:id, :course, :exercise, :revision, :choice, :case, :stability, :dry, 'grading', :by, :now)""",
            ).bind("id", id)
            .bind("course", course.id)
            .bind("exercise", exercise.id())
            .bind("revision", exercise.revision())
            .bind("choice", choice.code)
            .bind("case", case?.name())
            .bind("stability", case?.let { if (it.kind() == Exercise.Criterion.STABILITY) 1 else 0 })
            .bind("dry", if (dry) 1 else 0)
            .bind("by", by)
            .bind("now", clock.instant().text())
            .execute()
        return id
    }

    private fun insert(
        handle: Handle,
        regrade: String,
        one: Gradable,
        position: Int,
    ) {
        handle
            .createUpdate(
                """INSERT INTO regrade_items (regrade_id, submission_id, position, state)
                   VALUES (:regrade, :submission, :position, 'queued')""",
            ).bind("regrade", regrade)
            .bind("submission", one.submission)
            .bind("position", position)
            .execute()
    }

    private fun note(
        handle: Handle,
        course: String,
        by: String,
        action: String,
        subject: String,
        detail: String,
    ) = AuditNote(by, course, action, subject, detail).write(handle, clock.instant())

    private fun named(
        handle: Handle,
        id: String,
    ) = find(handle, id) ?: throw Rejection.UnknownRegrade(id)

    private fun find(
        handle: Handle,
        id: String,
    ) = rows(handle.createQuery("$SELECT WHERE id = :id").bind("id", id)).singleOrNull()

    private fun rows(query: Query): List<Regrade> = query.map { row, _ -> regrade(row) }.list()

    private fun regrade(row: ResultSet) =
        Regrade(
            row.getString("id"),
            row.getString("course_id"),
            row.getString("exercise"),
            row.getString("revision"),
            RegradeChoice.entries.single { it.code == row.getString("choice") },
            row.getString("case_name"),
            row.getInt("is_dry") == 1,
            RegradeState.entries.single { it.code == row.getString("state") },
            Instant.parse(row.getString("begun_at")),
            row.getString("settled_at")?.let(Instant::parse),
            row.getInt("total"),
            row.getInt("done"),
            row.getInt("failed"),
        )

    companion object {
        /** The most that are listed where nobody says. */
        const val LISTED = 100

        private const val OWN =
            "FROM regrade_items i LEFT JOIN results r ON r.id = i.result_id WHERE i.regrade_id = regrades.id"

        private const val SELECT =
            """SELECT regrades.*, (SELECT count(*) $OWN) AS total, (SELECT count(*) $OWN AND r.id IS NOT NULL) AS done,
                   (SELECT count(*) $OWN AND r.verdict = 'internal') AS failed
               FROM regrades"""
    }
}
