package rasterlab.grader.problem

import io.ktor.http.HttpStatusCode
import io.ktor.http.HttpStatusCode.Companion.BadRequest
import io.ktor.http.HttpStatusCode.Companion.Conflict
import io.ktor.http.HttpStatusCode.Companion.Forbidden
import io.ktor.http.HttpStatusCode.Companion.MethodNotAllowed
import io.ktor.http.HttpStatusCode.Companion.NotFound
import io.ktor.http.HttpStatusCode.Companion.PayloadTooLarge
import io.ktor.http.HttpStatusCode.Companion.RequestTimeout
import io.ktor.http.HttpStatusCode.Companion.ServiceUnavailable
import io.ktor.http.HttpStatusCode.Companion.TooManyRequests
import io.ktor.http.HttpStatusCode.Companion.Unauthorized
import io.ktor.http.HttpStatusCode.Companion.UnprocessableEntity
import io.ktor.http.HttpStatusCode.Companion.UnsupportedMediaType
import rasterlab.grader.limits.secondsToWait

/** The status of the answer that says no. */
fun Rejection.status(): HttpStatusCode =
    when (this) {
        is Rejection.NotSignedIn -> Unauthorized
        is Rejection.WrongRole, is Rejection.ForeignOrigin, is Rejection.ForeignComment -> Forbidden
        is Rejection.OnlyLooks -> Forbidden
        is Rejection.UnknownExercise, is Rejection.UnknownSubmission, is HiddenByExam -> NotFound
        is Rejection.UnknownPicture, is Rejection.UnknownScene -> NotFound
        is Rejection.UnknownCourse, is Rejection.UnknownStudent, is Rejection.UnknownStaff -> NotFound
        is Rejection.UnknownRegrade, is Rejection.UnknownAdjustment, is Rejection.UnknownComment -> NotFound
        is Rejection.UnknownGroup -> NotFound
        is Rejection.UnknownExam, is Rejection.UnknownWorker, is Rejection.UnknownPlatform -> NotFound
        is Rejection.UnknownComplaint, is Rejection.UnknownTrial -> NotFound
        is Rejection.InExam, is Rejection.ExamAddress -> Forbidden
        is Rejection.ExamNotOpen, is Rejection.ExamOver, is Rejection.OtherSession -> Conflict
        is Rejection.RegradeStands -> Conflict
        is Rejection.Malformed -> BadRequest
        is Rejection.BadName, is Rejection.BadKey, is Rejection.KeyReused -> UnprocessableEntity
        is Rejection.EmptySource, is Rejection.NotUtf8, is Rejection.UnknownLanguage -> UnprocessableEntity
        is Rejection.BadSheet, is Rejection.BadAnswers, is Rejection.Explained -> UnprocessableEntity
        is Rejection.NoMoreHints, is Rejection.HintOrder, is Rejection.Late, is Rejection.LastInstructor -> Conflict
        is Rejection.NotOpen, is Rejection.NoAttemptsLeft, is Rejection.NothingToChoose -> Conflict
        is Rejection.WrongMethod -> MethodNotAllowed
        is Rejection.TooLarge -> PayloadTooLarge
        is Rejection.WrongMediaType, is Rejection.Kotlin -> UnsupportedMediaType
        is Rejection.TooSlow -> RequestTimeout
        is Rejection.TooManyQueued, is Rejection.TooFast -> TooManyRequests
        is Rejection.NoRoom -> ServiceUnavailable
    }

/** Seconds after which the same request may succeed, or null. */
fun Rejection.retryAfter(): Int? =
    when (this) {
        is Rejection.TooManyQueued -> retryAfterSeconds
        is Rejection.TooFast -> allowance.refill.secondsToWait()
        is Rejection.NoRoom -> 60
        else -> null
    }
