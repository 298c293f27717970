package rasterlab.grader.lti

import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Courses
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.storage.Database
import java.net.URI
import java.time.InstantSource

/**
 * All that this server is to learning platforms.
 *
 * @param publicAddress of this server as browsers have it; null where each request tells it
 * @param wall the clock that people and platforms are told
 * @param steady the clock of what is due after a while
 * @param name of this server, which no other has that uses the database
 */
class Lti(
    database: Database,
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    val publicAddress: URI?,
    wall: InstantSource,
    steady: InstantSource,
    name: String,
) {
    val platforms = Platforms(database, wall)
    val key = ToolKey(database, wall)
    val bindings = Bindings(database, wall)
    val launches = Launches(platforms, database, wall)
    val arrivals = Arrivals(database, accounts, courses, exercises, bindings, platforms, wall)
    val deepLinks = DeepLinks(platforms, key, wall)
    val states = ScoreStates(database, wall, steady)
    val sender = ScoreSender(database, platforms, key, exercises, wall, steady, name)
}
