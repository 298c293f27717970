package rasterlab.grader.worker

/** Tells all who share the database that this process is here, and how it grades. */
class Presence(
    private val workers: Workers,
    private val own: () -> Worker,
) {
    fun begin() = workers.begin(own())

    /** Says that it is still here; returns whether it was asked to take nothing more. */
    fun seen(): Boolean {
        val now = own()
        // Whoever was silent for a day is off the list.
        if (!workers.seen(now)) workers.begin(now)
        return workers.isDraining(now.name)
    }

    fun end() = workers.end(own().name)
}
