package rasterlab.grader.web

import io.ktor.http.HttpStatusCode
import io.ktor.http.Parameters
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.form
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.rules.CourseClones

/** Lets an instructor make a course of an earlier one. */
fun Route.clonePages(
    accounts: Accounts,
    courses: Courses,
    clones: CourseClones,
) {
    get("/instructor/courses/{course}/clone") {
        val who = call.instructorHere(accounts)
        call.respondClone(who, call.courseOf(courses), typed = null, refused = null)
    }
    post("/instructor/courses/{course}/clone") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val course = call.courseOf(courses)
        val form = call.receiveForm()
        val again =
            FormAgain { status, code, added ->
                call.respondClone(who, course, form, Refused(status, code, added(call.texts().language)))
            }
        call.attributes.put(FORM_AGAIN, again)
        val made = clones.clone(course, Name.of(form["name"].orEmpty()), form["days"].orEmpty(), who.id, key = null)
        call.respondRedirect("/instructor/courses/${made.id}/exercises")
    }
}

private suspend fun ApplicationCall.respondClone(
    who: Identity.Instructor,
    course: Course,
    typed: Parameters?,
    refused: Refused?,
) {
    val texts = texts()
    respondPage(texts, who, texts.say("clone.title", course.name), refused?.status ?: HttpStatusCode.OK) {
        refused?.let { problem(texts, it.status, it.code, it.details) }
        p { a("/instructor") { +texts.say("token.back") } }
        section("card") {
            p { +texts.say("clone.about") }
            form("/instructor/courses/${course.id}/clone", method = FormMethod.post) {
                label {
                    span { +texts.say("instructor.course.name") }
                    input(InputType.text, name = "name") {
                        value = typed?.get("name") ?: course.name
                        required = true
                        attributes["autocomplete"] = "off"
                    }
                }
                label {
                    span { +texts.say("clone.days") }
                    input(InputType.number, name = "days") {
                        value = typed?.get("days") ?: "${CourseClones.YEAR_OF_WEEKS}"
                        required = true
                    }
                }
                button { +texts.say("clone.do") }
            }
        }
    }
}
