package rasterlab.grader.limits

/**
 * How much one student may hand in.
 *
 * @param waiting submissions not graded yet, so that nobody fills the queue for the others
 * @param perMinute submissions received within a minute
 */
data class IntakeLimits(
    val waiting: Int = 5,
    val perMinute: Int = 20,
) {
    /** Lowers each to what [others] allow. */
    fun atMost(others: IntakeLimits) = IntakeLimits(minOf(waiting, others.waiting), minOf(perMinute, others.perMinute))
}
