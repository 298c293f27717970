// What people do at exams in tests, by the forms that browsers send.
package rasterlab.grader.exam

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import io.ktor.http.formUrlEncode
import rasterlab.grader.Visit
import rasterlab.grader.cookieOf
import rasterlab.grader.one

/** An exam on the first of March 2027, at 10 UTC. */
internal val FIELDS =
    mapOf(
        "name" to "Midterm",
        "opens" to "2027-03-01T10:00",
        "closes" to "2027-03-01T12:00",
        "zone" to "UTC",
        "minutes" to "30",
        "starts" to "first",
        "grace" to "30",
        "addresses" to "",
        "second" to "refuse",
        "exercise" to "draw-dot",
    )

/** The kinds of the events of all exams, in order. */
internal fun Visit.kinds(): String =
    database
        .read { it.createQuery("SELECT kind FROM exam_events ORDER BY number").mapTo(String::class.java).list() }
        .joinToString(" ")

/** Makes an exam of a course, with some fields other than usual. */
internal suspend fun Visit.exam(
    course: String,
    vararg other: Pair<String, String>,
): String {
    val id = one("SELECT id FROM courses WHERE code = '$course'")
    val fields = (FIELDS + other).toList().toTypedArray()
    val made = send("/instructor/courses/$id/exams", cookieOf(instructor), *fields)
    return checkNotNull(made.headers[HttpHeaders.Location]) { made.bodyAsText() }.substringAfterLast('/')
}

/** Sends a form of a page from a browser. */
internal suspend fun Visit.send(
    path: String,
    cookie: String,
    vararg fields: Pair<String, String>,
) = client.post(path) {
    header(HttpHeaders.Cookie, cookie)
    header(HttpHeaders.Host, "localhost")
    header(HttpHeaders.Origin, "http://localhost")
    header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
    setBody(fields.toList().formUrlEncode())
}

/** Opens an exam. */
internal suspend fun Visit.open(
    exam: String,
    cookie: String,
) = send("/exams/$exam/open", cookie)

/** The page of a student's exams. */
internal suspend fun Visit.list(cookie: String) = page("/exams", cookie).bodyAsText()

/** The page of an exam, as a student has it. */
internal suspend fun Visit.seen(
    exam: String,
    cookie: String,
) = page("/exams/$exam", cookie).bodyAsText()

/** A page in a browser. */
internal suspend fun Visit.page(
    path: String,
    cookie: String,
): HttpResponse = client.get(path) { header(HttpHeaders.Cookie, cookie) }

/** Sends a text as a draft, or to another place of the exam. */
internal suspend fun Visit.draft(
    exam: String,
    cookie: String,
    source: String,
    vararg more: Pair<String, String>,
    to: String = "/draft",
) = client.post("/exams/$exam/exercises/draw-dot$to") {
    header(HttpHeaders.Cookie, cookie)
    header(HttpHeaders.Host, "localhost")
    header(HttpHeaders.Origin, "http://localhost")
    header(HttpHeaders.ContentType, "multipart/form-data; boundary=b")
    val fields = listOf("source" to source) + more
    setBody(
        fields.joinToString("") { (name, value) ->
            "--b\r\nContent-Disposition: form-data; name=\"$name\"\r\n\r\n$value\r\n"
        } + "--b--\r\n",
    )
}
