package rasterlab.grader.exercise

import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.http.withCharset
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respondBytes
import io.ktor.server.response.respondText
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Identity
import rasterlab.grader.course.identity
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.language
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.pictureLanguage
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.respondPart
import rasterlab.grader.rules.ExerciseRules
import rasterlab.grader.storage.text

@Serializable
private data class ExerciseView(
    val id: String,
    val topic: String,
    val kind: String,
    val title: String,
    val revision: String,
    val points: PlanView,
    val opens: String?,
    val deadline: String?,
    val attemptsLeft: Int?,
    val minutes: Int?,
    val state: String?,
    val best: Int?,
)

/**
 * How far a student has come.
 *
 * @param bests the most points, by exercise; null as long as nothing is graded
 * @param attempts made, by exercise
 */
class StudentStanding(
    val bests: Map<String, Int?>,
    val attempts: Map<String, Int>,
)

@Serializable
private data class PlanView(
    val accuracy: Int,
    val stability: Int,
    val speed: Int,
    val total: Int,
)

/**
 * Serves exercises, inside `authenticate`. A deadline is null where none is set, attempts left as
 * long as nobody limits them.
 *
 * @param closed the exercises that somebody does not get now
 * @param starter what somebody begins an exercise with
 * @param rules that hold for somebody, by exercise
 * @param standing how far somebody has come; null for whoever hands nothing in
 */
fun Route.exercises(
    exercises: Exercises,
    closed: (Identity) -> Set<String>,
    starter: (Identity, Exercise) -> String,
    rules: (Identity) -> Map<String, ExerciseRules>,
    standing: (Identity) -> StudentStanding?,
) {
    get("/exercises") {
        val held = rules(call.identity())
        val come = standing(call.identity())
        val shown = closed(call.identity()).let { kept -> exercises.all.filter { it.id() !in kept } }
        val part = call.paging(Paging.WHOLE).of(shown) { it.id() }
        call.respondPart(part.map { it.view(call.language(), held, come) })
    }
    get("/exercises/{id}") {
        val exercise = exercises.named(call.exerciseId())
        call.respondJson(exercise.view(call.language(), rules(call.identity()), standing(call.identity())))
    }
    get("/exercises/{id}/starter") {
        val exercise = exercises.named(call.exerciseId())
        call.respondStarter(exercise, starter(call.identity(), exercise))
    }
    get("/exercises/{id}/statement") {
        val exercise = exercises.named(call.exerciseId())
        call.respondText(
            exercise.statement(call.language()),
            ContentType("text", "markdown").withCharset(Charsets.UTF_8),
        )
    }
    get("/exercises/{id}/pictures/{name}") {
        call.respondPicture(exercises.named(call.exerciseId()), call.parameters.getOrFail("name"))
    }
}

/** The starter as a file to save. */
suspend fun ApplicationCall.respondStarter(
    exercise: Exercise,
    starter: String,
) {
    response.header(HttpHeaders.ContentDisposition, "attachment; filename=\"${exercise.starterFile()}\"")
    respondText(starter, ContentType.Text.Plain.withCharset(Charsets.UTF_8))
}

/** A picture of the statement. An SVG that is opened by itself runs and loads nothing. */
suspend fun ApplicationCall.respondPicture(
    exercise: Exercise,
    name: String,
) {
    val picture = exercise.pictures()[name] ?: throw Rejection.UnknownPicture(exercise.id(), name)
    response.header("Content-Security-Policy", "default-src 'none'; style-src 'unsafe-inline'; sandbox")
    respondBytes(picture.content(pictureLanguage()), ContentType.parse(picture.form().mediaType()))
}

/** The file name that the compiler wants for a starter in Java; of inputs the exercise's. */
fun Exercise.starterFile(): String {
    val name = if (form() == Exercise.TaskKind.WRITE) CLASS.find(starter())?.groupValues?.get(1) ?: "Starter" else id()
    return name + "." + form().ending()
}

private val CLASS = Regex("""\bclass\s+(\w+)""")

private fun ApplicationCall.exerciseId() = parameters.getOrFail("id")

private fun Exercise.view(
    language: String,
    rules: Map<String, ExerciseRules>,
    standing: StudentStanding?,
) = ExerciseView(
    id(),
    topic(),
    form().code(),
    title(language),
    revision(),
    PlanView(points().accuracy(), points().stability(), points().speed(), points().total()),
    opens = rules[id()]?.opens?.text(),
    deadline = rules[id()]?.due?.text(),
    attemptsLeft = rules[id()]?.attempts?.let { maxOf(0, it - (standing?.attempts?.get(id()) ?: 0)) },
    minutes = if (minutes().isPresent) minutes().asInt else null,
    state = standing?.let { stateOf(id(), it.bests) },
    best = standing?.bests?.get(id()),
)

private fun stateOf(
    id: String,
    bests: Map<String, Int?>,
) = when {
    id !in bests -> "not-tried"
    bests[id] == null -> "waiting"
    else -> "graded"
}
