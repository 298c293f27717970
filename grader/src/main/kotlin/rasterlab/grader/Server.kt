// The grading server: its command line and how its parts are joined. Start here, then see submission.
package rasterlab.grader

import io.ktor.server.application.Application
import io.ktor.server.application.ApplicationCall
import io.ktor.server.application.ApplicationCallPipeline
import io.ktor.server.application.call
import io.ktor.server.application.install
import io.ktor.server.auth.Authentication
import io.ktor.server.auth.authenticate
import io.ktor.server.plugins.origin
import io.ktor.server.plugins.ratelimit.RateLimit
import io.ktor.server.plugins.ratelimit.RateLimitName
import io.ktor.server.plugins.ratelimit.rateLimit
import io.ktor.server.plugins.statuspages.StatusPages
import io.ktor.server.routing.IgnoreTrailingSlash
import io.ktor.server.routing.Route
import io.ktor.server.routing.route
import io.ktor.server.routing.routing
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import rasterlab.exercises.Grading
import rasterlab.exercises.runner.Isolation
import rasterlab.grader.adjustment.Adjustments
import rasterlab.grader.adjustment.adjustments
import rasterlab.grader.api.apiDescription
import rasterlab.grader.classroom.ClassFront
import rasterlab.grader.classroom.Efforts
import rasterlab.grader.classroom.GroupComments
import rasterlab.grader.classroom.LastResults
import rasterlab.grader.classroom.efforts
import rasterlab.grader.classroom.errors
import rasterlab.grader.classroom.fronts
import rasterlab.grader.classroom.groupComments
import rasterlab.grader.comment.Comments
import rasterlab.grader.comment.KeptComments
import rasterlab.grader.comment.comments
import rasterlab.grader.comment.copyKeptComments
import rasterlab.grader.comment.courseComments
import rasterlab.grader.comparison.VersionPairs
import rasterlab.grader.comparison.comparisons
import rasterlab.grader.complaint.ComplaintDesk
import rasterlab.grader.complaint.complaints
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Audit
import rasterlab.grader.course.CourseGuard
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.RosterImport
import rasterlab.grader.course.Staff
import rasterlab.grader.course.byToken
import rasterlab.grader.course.courses
import rasterlab.grader.course.guardCourses
import rasterlab.grader.course.joining
import rasterlab.grader.course.roster
import rasterlab.grader.course.staff
import rasterlab.grader.exam.ExamGuard
import rasterlab.grader.exam.Exams
import rasterlab.grader.exam.Sittings
import rasterlab.grader.exam.exams
import rasterlab.grader.exam.guardExams
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.exercise.exercises
import rasterlab.grader.forwarding.Forwarding
import rasterlab.grader.hint.Hints
import rasterlab.grader.hint.hints
import rasterlab.grader.institution.InstitutionSignIn
import rasterlab.grader.limits.limit
import rasterlab.grader.lti.Lti
import rasterlab.grader.lti.lti
import rasterlab.grader.metrics.Meters
import rasterlab.grader.problem.refuseOtherMethods
import rasterlab.grader.problem.showProblems
import rasterlab.grader.problem.waitForBodies
import rasterlab.grader.regrade.Regrades
import rasterlab.grader.regrade.regrades
import rasterlab.grader.report.CopiedResults
import rasterlab.grader.report.Grades
import rasterlab.grader.report.Results
import rasterlab.grader.report.grades
import rasterlab.grader.report.results
import rasterlab.grader.rules.CourseClones
import rasterlab.grader.rules.CourseExercises
import rasterlab.grader.rules.CourseLimits
import rasterlab.grader.rules.CourseRules
import rasterlab.grader.rules.clones
import rasterlab.grader.rules.courseExercises
import rasterlab.grader.rules.courseLimits
import rasterlab.grader.rules.exerciseRules
import rasterlab.grader.rules.tellZones
import rasterlab.grader.similarity.Similar
import rasterlab.grader.similarity.similarity
import rasterlab.grader.storage.Database
import rasterlab.grader.student.StudentRecords
import rasterlab.grader.student.studentRecords
import rasterlab.grader.submission.Attempts
import rasterlab.grader.submission.Choices
import rasterlab.grader.submission.GradingQueue
import rasterlab.grader.submission.Intake
import rasterlab.grader.submission.Leases
import rasterlab.grader.submission.Live
import rasterlab.grader.submission.Marks
import rasterlab.grader.submission.Reports
import rasterlab.grader.submission.SharedMoves
import rasterlab.grader.submission.Sheets
import rasterlab.grader.submission.SteadyClock
import rasterlab.grader.submission.Submissions
import rasterlab.grader.submission.courseSubmissions
import rasterlab.grader.submission.submissions
import rasterlab.grader.trial.StaffCopies
import rasterlab.grader.trial.TrialDesk
import rasterlab.grader.trial.trials
import rasterlab.grader.web.ErrorPage
import rasterlab.grader.web.PageParts
import rasterlab.grader.web.classroom.effortPages
import rasterlab.grader.web.classroom.errorPages
import rasterlab.grader.web.classroom.frontPages
import rasterlab.grader.web.comment.CommentedSource
import rasterlab.grader.web.comment.commentPages
import rasterlab.grader.web.comment.questionPages
import rasterlab.grader.web.comparison.comparePages
import rasterlab.grader.web.complaint.CaseComplaints
import rasterlab.grader.web.complaint.complaintPages
import rasterlab.grader.web.exam.examPages
import rasterlab.grader.web.gradesPages
import rasterlab.grader.web.institution.institutionPages
import rasterlab.grader.web.lti.launchPages
import rasterlab.grader.web.lti.platformPages
import rasterlab.grader.web.lti.scorePages
import rasterlab.grader.web.lti.toolPages
import rasterlab.grader.web.monitoring
import rasterlab.grader.web.pages
import rasterlab.grader.web.protect
import rasterlab.grader.web.rules.courseExercisePages
import rasterlab.grader.web.similarity.similarPages
import rasterlab.grader.web.trial.trialPages
import rasterlab.grader.web.view.viewPages
import rasterlab.grader.worker.Presence
import rasterlab.grader.worker.Worker
import rasterlab.grader.worker.Workers
import rasterlab.grader.worker.workers
import java.time.InstantSource

/**
 * The grading server without its socket: what it is made of, and how the parts are joined.
 *
 * @param isolation what shuts the students' methods in when [grading] runs them
 * @param steady the clock of what is due after a while
 * @param children how many processes that compile and run sources live now
 */
class Server(
    private val database: Database,
    private val exercises: Exercises,
    grading: Grading,
    private val isolation: () -> Isolation,
    private val settings: ServerSettings = ServerSettings(),
    clock: InstantSource = InstantSource.system(),
    private val steady: SteadyClock = SteadyClock(clock),
    stopping: () -> Boolean = { false },
    children: () -> Int = { 0 },
) : AutoCloseable {
    val accounts = Accounts(database, clock)
    private val institution =
        settings.institution?.let { InstitutionSignIn(it, database, accounts, clock) }
    private val courses = Courses(database, clock)
    private val staff = Staff(database, clock)
    private val audit = Audit(database)
    private val rules = CourseRules(database, clock)
    private val chosen = CourseExercises(database, exercises.all.map { it.id() }, clock)
    private val limits = CourseLimits(database, settings.intake, clock)
    private val roster = RosterImport(database, clock)
    private val marks = Marks(database)
    private val grades = Grades(courses, marks, exercises, chosen)
    private val clones = CourseClones(database, clock, ::copyKeptComments)
    private val regrades = Regrades(database, clock)
    private val records = StudentRecords(database, clock)
    private val moves = SharedMoves(database, settings.name)
    private val live = Live(moves::tell)
    private val submissions = Submissions(database)
    private val similar = Similar(database)
    private val last = LastResults(database)
    private val groupComments = GroupComments(database, clock, last)
    private val front = ClassFront(database)
    private val reports = Reports(database)
    private val adjustments = Adjustments(database, clock)
    private val comments = Comments(database, clock)
    private val keptComments = KeptComments(database, clock)
    private val results = Results(submissions, reports, live, exercises, rules, adjustments, clock)
    private val intake = Intake(database, settings.intake, clock)
    private val choices = Choices(database)
    private val sheets = Sheets(database)
    private val hints = Hints(database, clock)
    private val efforts = Efforts(database, hints)
    private val leases = Leases(database, reports, clock, steady, settings.name)
    private val meters = Meters(database, children, clock)
    private val attempts =
        Attempts(database, leases, exercises, meters.timed(grading), live, meters::waited, stopping = stopping)
    private val workers = Workers(database, steady, Leases.LENGTH)
    private val queue =
        GradingQueue(
            database,
            submissions,
            leases,
            attempts,
            live,
            steady,
            settings.workers,
            settings.name,
            Presence(workers) { Worker.here(settings.name, serves = true, isolation(), settings.workers) },
        )
    private val complaints =
        ComplaintDesk(
            database,
            courses,
            exercises,
            regrades,
            { who, id -> results.view(who, id).cases },
            queue::ring,
            clock,
        )
    private val pairs = VersionPairs(submissions, results)
    private val copied = CopiedResults(reports, results, live, exercises)
    private val trialDesk = TrialDesk(StaffCopies(database, clock), submissions, exercises, copied, queue::ring)
    private val exams = Exams(database, steady)
    private val sittings = Sittings(database, exercises, intake, steady, queue::ring)
    private val lti = Lti(database, accounts, courses, exercises, settings.publicAddress, clock, steady, settings.name)
    private val pageParts =
        PageParts(
            accounts,
            institution,
            courses,
            staff,
            audit,
            rules,
            clones,
            regrades,
            roster,
            marks,
            records,
            exercises,
            sheets,
            hints,
            submissions,
            intake,
            choices,
            queue,
            results,
            adjustments,
            comments,
            groupComments,
            CommentedSource(comments, keptComments, courses),
            CaseComplaints(complaints, ::isFree),
            ::isFree,
            complaints,
            live,
            workers,
            isolation,
            ::closedTo,
            clock,
        )

    /** Whether somebody has no exam now, beside which there is nothing. */
    private fun isFree(who: Identity) = who !is Identity.StudentIdentity || sittings.holding(who) == null

    /** The exercises that somebody does not get now. */
    private fun closedTo(who: Identity): Set<String> = sittings.closedTo(who) + chosen.closedTo(who)

    /** Begins to grade what waits. */
    fun startGrading() {
        queue.start(sittings::settle)
        moves.listen(live::heard)
        lti.sender.start()
    }

    /** @param address at the other end of the connection, which may be a proxy's */
    fun install(
        application: Application,
        address: (ApplicationCall) -> String = { it.request.origin.remoteAddress },
    ) = with(application) {
        val forwarding = Forwarding(settings.proxies, address, settings.encrypted)
        intercept(ApplicationCallPipeline.Setup) { forwarding.note(call) }
        // The database blocks its caller, so no request is handled on the few threads that serve the sockets.
        intercept(ApplicationCallPipeline.Setup) { withContext(Dispatchers.IO) { proceed() } }
        waitForBodies(settings.bodyPatience)
        install(IgnoreTrailingSlash)
        install(StatusPages) { showProblems(ErrorPage) }
        install(Authentication) { byToken(accounts) }
        install(RateLimit) { limit(ENTRY, settings.entriesPerMinute, steady, forwarding::clientOf) }
        protect()
        guardCourses(CourseGuard(accounts, database))
        tellZones(accounts, database)
        guardExams(ExamGuard(accounts, sittings, submissions, chosen::closedTo))
        routing {
            monitoring(database, isolation, meters)
            apiDescription()
            servePages()
            serveApi()
        }.refuseOtherMethods()
    }

    private fun Route.servePages() {
        pages(pageParts, ENTRY)
        rateLimit(ENTRY) { institutionPages(institution, accounts) }
        toolPages(lti)
        rateLimit(ENTRY) { launchPages(lti, accounts, exercises, chosen) }
        platformPages(accounts, lti)
        scorePages(accounts, courses, exercises, lti)
        gradesPages(accounts, grades)
        courseExercisePages(accounts, courses, exercises, chosen, rules, limits)
        examPages(accounts, courses, exercises, exams, sittings, sheets)
        similarPages(accounts, courses, exercises, similar)
        errorPages(accounts, courses, exercises, last, groupComments)
        commentPages(accounts, courses, submissions, comments, keptComments, pageParts.resultPage)
        trialPages(accounts, trialDesk, live)
        viewPages(accounts, submissions)
        comparePages(accounts, exercises, pairs)
        complaintPages(accounts, courses, exercises, submissions, complaints, pageParts.resultPage)
        questionPages(accounts, courses, exercises, comments, keptComments)
        effortPages(accounts, courses, exercises, efforts)
        frontPages(accounts, courses, exercises, front)
    }

    private fun Route.serveApi() =
        route("/api/v1") {
            rateLimit(ENTRY) { joining(courses) }
            authenticate {
                courses(courses, accounts)
                staff(staff, audit)
                workers(workers)
                roster(courses, roster)
                grades(grades)
                exercises(exercises, ::closedTo, sheets::starter, rules::of, submissions::standingOf)
                exerciseRules(courses, rules, chosen, exercises.all.map { it.id() }) { exercises.named(it) }
                courseExercises(courses, chosen)
                courseLimits(courses, limits)
                clones(courses, clones)
                regrades(courses, exercises, regrades, queue, live)
                studentRecords(records, exercises::ending)
                hints(exercises, hints, courses)
                similarity(courses, exercises, similar)
                errors(courses, exercises, last, groupComments)
                groupComments(exercises, submissions, groupComments)
                efforts(courses, exercises, efforts)
                fronts(courses, exercises, front)
                submissions(exercises, intake, queue, choices)
                courseSubmissions(courses, exercises, submissions)
                adjustments(submissions, adjustments)
                exams(courses, exercises, exams, sittings)
                comments(submissions, comments)
                courseComments(courses, comments, keptComments)
                trials(trialDesk)
                comparisons(pairs)
                complaints(submissions, courses, complaints)
                results(results, live)
                lti(lti.platforms, lti.key, courses, lti.states)
            }
        }

    /** Lets running attempts end or puts them back. */
    override fun close() {
        lti.sender.close()
        queue.close()
        moves.close()
    }

    private companion object {
        val ENTRY = RateLimitName("entry")
    }
}
