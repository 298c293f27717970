package rasterlab.grader.student

import kotlinx.serialization.Serializable

/** A result of a submission; what hidden cases found stays with the exercise. */
@Serializable
data class KeptResult(
    val run: Int,
    val current: Boolean,
    val revision: String,
    val verdict: String,
    val accuracy: Int,
    val stability: Int,
    val speed: Int,
    val of: Int,
    val gradedAt: String,
)

/** Points that staff gave or took; those that were taken back too. */
@Serializable
data class KeptPoints(
    val points: Int,
    val reason: String,
    val givenAt: String,
    val revokedAt: String?,
)

@Serializable
data class KeptSubmission(
    val id: String,
    val exercise: String,
    val revision: String,
    val attempt: Int,
    val receivedAt: String,
    val deadline: String?,
    val hintCost: Int,
    val chosen: Boolean,
    val source: String,
    val results: List<KeptResult>,
    val points: List<KeptPoints>,
)

@Serializable
data class KeptHint(
    val exercise: String,
    val step: Int,
    val cost: Int,
    val takenAt: String,
)

@Serializable
data class KeptExtension(
    val exercise: String,
    val deadline: String,
    val reason: String,
)

/**
 * Words of the student about a submission, or of staff.
 *
 * @param thread id of the comment that it answers; null where it begins a thread
 * @param name of who wrote it; empty for the first instructor
 */
@Serializable
data class KeptComment(
    val id: String,
    val submission: String,
    val thread: String?,
    val line: Int?,
    val lastLine: Int?,
    val name: String,
    val text: String,
    val writtenAt: String,
    val editedAt: String?,
)

/** A complaint of the student against the result for a case, and its answer; null where there is none yet. */
@Serializable
data class KeptComplaint(
    val submission: String,
    val case: String,
    val text: String,
    val openedAt: String,
    val state: String,
    val answer: String?,
    val answeredAt: String?,
)

/** The text that the student wrote last for an exercise of an exam. */
@Serializable
data class KeptDraft(
    val exam: String,
    val exercise: String,
    val savedAt: String,
    val source: String,
)

/** A line of the student in the protocol of an exam. */
@Serializable
data class KeptExamEvent(
    val exam: String,
    val notedAt: String,
    val kind: String,
    val address: String,
    val detail: String,
)

/** Whom a learning platform means by the student. */
@Serializable
data class KeptPlatform(
    val issuer: String,
    val clientId: String,
    val subject: String,
)

/** Points of the student as a learning platform has them, or is to have them. */
@Serializable
data class KeptScore(
    val issuer: String,
    val exercise: String,
    val points: Int?,
    val of: Int,
    val sentPoints: Int?,
    val sentAt: String?,
)

/**
 * Everything that is kept about a student.
 *
 * @param namedOnFront whether the class reads the name on its chart of speed and accuracy
 * @param roster what rosters said, by the meaning of the column
 */
@Serializable
data class KeptStudent(
    val student: String,
    val course: String,
    val courseName: String,
    val number: Int,
    val name: String,
    val shownName: String,
    val joinedAt: String,
    val namedOnFront: Boolean,
    val roster: Map<String, String>,
    val extensions: List<KeptExtension>,
    val hints: List<KeptHint>,
    val submissions: List<KeptSubmission>,
    val comments: List<KeptComment>,
    val complaints: List<KeptComplaint> = emptyList(),
    val drafts: List<KeptDraft> = emptyList(),
    val examEvents: List<KeptExamEvent> = emptyList(),
    val platforms: List<KeptPlatform> = emptyList(),
    val scores: List<KeptScore> = emptyList(),
)
