package rasterlab.grader.classroom

import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respondText
import io.ktor.server.routing.Route
import io.ktor.server.routing.delete
import io.ktor.server.routing.get
import io.ktor.server.routing.put
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.exercises.Exercise
import rasterlab.grader.comment.CommentText
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.identity
import rasterlab.grader.course.staff
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.language
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Submissions

@Serializable
private data class MappedCaseAnswer(
    val name: String,
    val title: String,
    val visibility: String,
    val passed: Int,
    val failed: Int,
    val notRun: Int,
    val nobodyPasses: Boolean,
    val differences: String?,
)

@Serializable
private data class MemberAnswer(
    val student: String,
    val name: String,
    val submission: String,
)

@Serializable
private data class WrongGroupAnswer(
    val group: String,
    val mistake: String?,
    val cases: List<String>,
    val members: List<MemberAnswer>,
    val comment: GroupCommentAnswer?,
)

/** A comment to a group of the same wrong answers. */
@Serializable
private data class GroupCommentAnswer(
    val group: String,
    val text: String,
    val name: String,
    val writtenAt: String,
)

@Serializable
private data class ToldAnswer(
    val comment: GroupCommentAnswer?,
)

@Serializable
private data class LastResultAnswer(
    val student: String,
    val name: String,
    val submission: String,
    val attempt: Int,
    val verdict: String,
    val failed: List<String>,
)

@Serializable
private data class ErrorMapAnswer(
    val students: Int,
    val cases: List<MappedCaseAnswer>,
    val groups: List<WrongGroupAnswer>,
    val results: List<LastResultAnswer>,
    val next: Int?,
)

/** Serves to staff which cases of an exercise fail, and for whom, inside `authenticate`. */
fun Route.errors(
    courses: Courses,
    exercises: Exercises,
    last: LastResults,
    comments: GroupComments,
) {
    get("/courses/{course}/exercises/{id}/errors") {
        call.staff()
        val language = call.language()
        val course = call.course(courses)
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        val from = call.from()
        call.respondJson(
            answer(
                ErrorMap(last.of(course.id, exercise.id()), exercise),
                comments.of(course, exercise),
                course,
                exercise,
                from,
                language,
            ),
        )
    }
    put("/courses/{course}/exercises/{id}/errors/groups/{group}/comment") {
        val who = call.staff()
        val course = call.course(courses)
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        val text = CommentText.of(call.receiveJson("text") { it.anyText("text") })
        call.respondJson(answer(comments.write(who, course, exercise, call.group(), text)))
    }
    delete("/courses/{course}/exercises/{id}/errors/groups/{group}/comment") {
        val who = call.staff()
        val course = call.course(courses)
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        call.respondJson(answer(comments.drop(who, course, exercise, call.group())))
    }
    get("/courses/{course}/exercises/{id}/errors/{case}/differences.svg") {
        call.staff()
        val course = call.course(courses)
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        val case = call.parameters.getOrFail("case")
        val sum = last.sum(course, exercise, case) ?: throw Rejection.UnknownPicture(case, "differences.svg")
        call.response.header(HttpHeaders.CacheControl, "private, no-store")
        call.respondText(sum.svg(), ContentType.Image.SVG)
    }
}

/** Serves what is said to all who gave the wrong answers of a submission, inside `authenticate`. */
fun Route.groupComments(
    exercises: Exercises,
    submissions: Submissions,
    comments: GroupComments,
) = get("/submissions/{id}/group-comment") {
    val submission = submissions.seenBy(call.identity(), call.parameters.getOrFail("id"))
    val told = exercises.find(submission.exercise)?.let { comments.to(submission, it) }
    call.respondJson(ToldAnswer(told?.let(::answer)))
}

/** The id of a group in an address. */
fun ApplicationCall.group(): String = parameters.getOrFail("group")

/** The sum of the differences of a case that all are asked alike; null where there is none. */
fun LastResults.sum(
    course: Course,
    exercise: Exercise,
    case: String,
): DifferenceSum? {
    if (exercise.cases().any { it.name() == case && it.generated() }) return null
    return DifferenceSum(differences(course.id, exercise.id(), case)).takeUnless { it.isEmpty }
}

/** The address of a case's sum. */
fun differencesAddress(
    course: Course,
    exercise: Exercise,
    case: String,
) = "/api/v1/courses/${course.id}/exercises/${exercise.id()}/errors/$case/differences.svg"

/**
 * How many students stand before the page that is asked for.
 *
 * @throws Rejection.Malformed where it is no number from 0
 */
fun ApplicationCall.from(): Int {
    val told = request.queryParameters["from"] ?: return 0
    return told.toIntOrNull()?.takeIf { it >= 0 }
        ?: throw Rejection.Malformed("from is '$told', allowed is a whole number from 0")
}

/** Students on one page. */
internal const val PAGE = 100

/** The place where the next page begins; null on the last one. */
internal fun nextPage(
    from: Int,
    all: Int,
): Int? = (from.toLong() + PAGE).takeIf { it < all }?.toInt()

private fun answer(one: GroupComment) = GroupCommentAnswer(one.group, one.text, one.name, one.writtenAt.text())

private fun answer(
    map: ErrorMap,
    comments: Map<String, GroupComment>,
    course: Course,
    exercise: Exercise,
    from: Int,
    language: String,
) = ErrorMapAnswer(
    map.results.size,
    map.cases.map { case ->
        MappedCaseAnswer(
            case.name,
            exercise.caseTitle(case.name, language),
            case.visibility.code(),
            case.passed,
            case.failed,
            case.notRun,
            case.nobodyPasses,
            differencesAddress(course, exercise, case.name).takeIf { case.summed },
        )
    },
    map.groups.map { group ->
        WrongGroupAnswer(
            group.id,
            group.mistake.inJson(language).ifEmpty { null },
            group.cases,
            group.members.map { MemberAnswer(it.student, it.name, it.submission) },
            comments[group.id]?.let(::answer),
        )
    },
    map.results.drop(from).take(PAGE).map { one ->
        LastResultAnswer(
            one.student,
            one.name,
            one.submission,
            one.attempt,
            one.verdict,
            one.cases.filterNot { it.passed }.map { it.name },
        )
    },
    nextPage(from, map.results.size),
)
