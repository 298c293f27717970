package rasterlab.grader.storage

import rasterlab.grader.exam.ExamTest
import rasterlab.grader.exercise.KeptExercisesTest
import rasterlab.grader.lti.ToolKeyTest
import rasterlab.grader.metrics.MetersTest
import rasterlab.grader.postgres.OnPostgres
import rasterlab.grader.regrade.RegradesTest
import rasterlab.grader.submission.AttemptsTest
import rasterlab.grader.submission.MeasurementsTest
import rasterlab.grader.submission.ReportsTest
import rasterlab.grader.submission.SpeedBandsTest
import rasterlab.grader.submission.TurnsTest
import rasterlab.grader.web.PagesTest

// The tests whose statements are the most different from each other, once more, in the other engine.

@OnPostgres
class AttemptsOnPostgresTest : AttemptsTest()

/** Students have a time at an exam, and one browser. */
@OnPostgres
class ExamOnPostgresTest : ExamTest()

@OnPostgres
class KeptExercisesOnPostgresTest : KeptExercisesTest()

@OnPostgres
class MeasurementsOnPostgresTest : MeasurementsTest()

@OnPostgres
class MetersOnPostgresTest : MetersTest()

/** Students join, hand in, are graded, and see the page of it. */
@OnPostgres
class PagesOnPostgresTest : PagesTest()

@OnPostgres
class RegradesOnPostgresTest : RegradesTest()

@OnPostgres
class ReportsOnPostgresTest : ReportsTest()

@OnPostgres
class SpeedBandsOnPostgresTest : SpeedBandsTest()

/** Two servers change the key that they share. */
@OnPostgres
class ToolKeyOnPostgresTest : ToolKeyTest()

@OnPostgres
class TurnsOnPostgresTest : TurnsTest()
