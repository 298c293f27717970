package rasterlab.grader.web

import com.fasterxml.jackson.databind.ObjectMapper
import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsText
import rasterlab.grader.Visit
import rasterlab.grader.bearer
import rasterlab.grader.course.Staff
import rasterlab.grader.json
import rasterlab.grader.text
import java.time.InstantSource

private val MAPPER = ObjectMapper()

/** Words that name something here, by the parameter that takes them. */
internal suspend fun Visit.known(): Map<String, List<String>> {
    val made =
        client
            .post("/api/v1/courses") {
                bearer(instructor)
                json("""{"name":"Graphics"}""")
            }.json()
    val course = made.text("course")
    val student = newStudent(made.text("code"))
    newStudent(made.text("code"))
    val all = MAPPER.readTree(look(instructor, "/api/v1/courses/$course/students").bodyAsText())
    val id = submit(student).json().text("id")
    eventsToTheEnd(student, id)
    val begun =
        client.post("/api/v1/courses/$course/exercises/draw-dot/regrade?dry=true") {
            bearer(instructor)
            json("{}")
        }
    val regrade = begun.json().text("regrade")
    look(instructor, "/api/v1/regrades/$regrade/events").bodyAsText()
    val given =
        List(2) {
            client.patch("/api/v1/submissions/$id/points") {
                bearer(instructor)
                json("""{"points":1,"reason":"fine"}""")
            }
        }
    val adjustments = MAPPER.readTree(given.last().bodyAsText()).path("adjustments").map { it.path("id").asText() }
    val comments =
        List(2) {
            client.post("/api/v1/submissions/$id/comments") {
                bearer(student)
                json("""{"text":"Why?","line":1}""")
            }
        }
    val (exam, examined) = exam()
    return mapOf(
        "platform" to listOf(platform()),
        "exam" to listOf(exam),
        "adjustment" to adjustments,
        "comment" to comments.map { it.json().text("id") },
        "other" to listOf(id),
        "trial" to listOf(trial(id)),
        "complaint" to listOf(complaint(student, id)),
        "kept" to listOf(kept(course)),
        "regrade" to listOf(regrade),
        "course" to listOf(course),
        "id" to listOf("draw-dot", id),
        "student" to listOf(all.last().path("student").asText(), examined),
        "staff" to listOf(Staff(database, InstantSource.system()).all().first().id),
        "case" to listOf("open-case", "hidden-case"),
        "picture" to listOf("expected.png", "actual.png"),
        "name" to listOf("dot.svg"),
        "token" to listOf(student, student, instructor, instructor, "", "no-token"),
    )
}

/** A copy of that submission that staff run. */
private suspend fun Visit.trial(submission: String): String =
    client
        .post("/api/v1/submissions/$submission/trials") {
            bearer(instructor)
            header("Content-Type", "text/x-java-source")
            setBody("class Dot { }")
        }.json()
        .text("id")

/** A comment that a course keeps. */
private suspend fun Visit.kept(course: String): String =
    client
        .post("/api/v1/courses/$course/kept-comments") {
            bearer(instructor)
            json("""{"name":"names","text":"Say it in the name."}""")
        }.json()
        .text("id")

/** A complaint about a case of that submission. */
private suspend fun Visit.complaint(
    student: String,
    submission: String,
): String =
    client
        .post("/api/v1/submissions/$submission/complaints") {
            bearer(student)
            json("""{"case":"open-case","text":"Why?"}""")
        }.json()
        .text("id")

/** A platform that is registered. */
private suspend fun Visit.platform(): String =
    client
        .post("/api/v1/lti/platforms") {
            bearer(instructor)
            json(
                """{"name":"Moodle","issuer":"https://m.example","clientId":"c","deployment":"1",
                    "loginUrl":"https://m.example/l","tokenUrl":"https://m.example/t","keysUrl":"https://m.example/k"}""",
            )
        }.json()
        .text("platform")

/** An exam and a student of it, in a course of its own: nobody gets its exercise in that one. */
private suspend fun Visit.exam(): Pair<String, String> {
    val course =
        client
            .post("/api/v1/courses") {
                bearer(instructor)
                json("""{"name":"Examined"}""")
            }.json()
    newStudent(course.text("code"))
    val made =
        client.post("/api/v1/courses/${course.text("course")}/exams") {
            bearer(instructor)
            json(
                """{"name":"Midterm","exercises":["draw-dot"],"opens":"2037-03-01T10:00","closes":"2037-03-01T12:00",
                    "minutes":30,"grace":30}""",
            )
        }
    val students = look(instructor, "/api/v1/courses/${course.text("course")}/students").bodyAsText()
    return made.json().text("exam") to
        MAPPER
            .readTree(students)
            .last()
            .path("student")
            .asText()
}
