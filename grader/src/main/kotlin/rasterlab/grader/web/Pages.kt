/*
 * The pages for people and what machines watch.
 * Pages lists the routes; each page is HTML that kotlinx.html escapes.
 */
package rasterlab.grader.web

import io.ktor.server.http.content.staticResources
import io.ktor.server.plugins.ratelimit.RateLimitName
import io.ktor.server.plugins.ratelimit.rateLimit
import io.ktor.server.routing.Route
import rasterlab.exercises.runner.Isolation
import rasterlab.grader.adjustment.Adjustments
import rasterlab.grader.classroom.GroupComments
import rasterlab.grader.comment.Comments
import rasterlab.grader.complaint.ComplaintDesk
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Audit
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.RosterImport
import rasterlab.grader.course.Staff
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.hint.Hints
import rasterlab.grader.institution.InstitutionSignIn
import rasterlab.grader.regrade.Regrades
import rasterlab.grader.report.Results
import rasterlab.grader.rules.CourseClones
import rasterlab.grader.rules.CourseRules
import rasterlab.grader.student.StudentRecords
import rasterlab.grader.submission.Choices
import rasterlab.grader.submission.GradingQueue
import rasterlab.grader.submission.Intake
import rasterlab.grader.submission.Live
import rasterlab.grader.submission.Marks
import rasterlab.grader.submission.Sheets
import rasterlab.grader.submission.Submissions
import rasterlab.grader.worker.Workers
import java.time.InstantSource

/** The pages for people, and the files that they use. */
fun Route.pages(
    parts: PageParts,
    entry: RateLimitName,
) = with(parts) {
    staticResources("/assets", "rasterlab.grader.web.assets")
    staticResources(LIBRARIES, "META-INF.resources.webjars")
    welcome(accounts, institution)
    rateLimit(entry) { entering(accounts, courses, institution) }
    exercisePages(accounts, rules, exercises, sheets, hints, submissions, intake, queue, closed, clock)
    choicePages(accounts, choices)
    hintPages(accounts, exercises, hints)
    resultPages(accounts, exercises, submissions, results, resultPage)
    markingPages(accounts, courses, exercises, submissions, adjustments, regrades, resultPage)
    instructorPages(accounts, courses, exercises, submissions, comments, complaints, hints, live, isolation)
    rulesPages(accounts, courses, exercises, rules)
    regradePages(accounts, courses, exercises, regrades, queue, live)
    rosterPages(accounts, courses, roster, submissions, marks)
    studentPages(accounts, exercises, submissions, records)
    clonePages(accounts, courses, clones)
    staffPages(accounts, staff, courses)
    auditPages(accounts, audit, exercises)
    workerPages(accounts, workers)
}

/**
 * The services that the pages ask.
 *
 * @param free whether somebody has no exam now
 * @param closed the exercises that somebody does not get now
 */
class PageParts(
    val accounts: Accounts,
    val institution: InstitutionSignIn?,
    val courses: Courses,
    val staff: Staff,
    val audit: Audit,
    val rules: CourseRules,
    val clones: CourseClones,
    val regrades: Regrades,
    val roster: RosterImport,
    val marks: Marks,
    val records: StudentRecords,
    val exercises: Exercises,
    val sheets: Sheets,
    val hints: Hints,
    val submissions: Submissions,
    val intake: Intake,
    val choices: Choices,
    val queue: GradingQueue,
    val results: Results,
    val adjustments: Adjustments,
    val comments: Comments,
    val groupComments: GroupComments,
    handed: HandedView,
    cases: CaseView,
    free: (Identity) -> Boolean,
    val complaints: ComplaintDesk,
    val live: Live,
    val workers: Workers,
    val isolation: () -> Isolation,
    val closed: (Identity) -> Set<String>,
    val clock: InstantSource,
) {
    val resultPage = ResultPage(exercises, submissions, results, adjustments, groupComments, handed, cases, free)
}
