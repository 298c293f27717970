package rasterlab.grader.problem

/** The submission is the student's own, and its exercise is kept for an exam now. */
class HiddenByExam(
    submission: String,
) : Rejection(
        "your submission '$submission' is hidden while an exam has its exercise; look again when the exam is over",
        "hidden-by-exam",
    )
