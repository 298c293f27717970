package rasterlab.grader.problem

import io.ktor.http.HttpHeaders
import io.ktor.http.ParametersBuilder
import io.ktor.http.formUrlEncode
import io.ktor.server.application.ApplicationCall
import io.ktor.server.request.path
import io.ktor.server.response.header

/**
 * A part of a list.
 *
 * @param next id behind which the rest begins; null where there is none
 */
class ListPart<T>(
    val items: List<T>,
    val next: String?,
) {
    fun <R> map(change: (T) -> R): ListPart<R> = ListPart(items.map(change), next)
}

/**
 * The part of a list that is asked for.
 *
 * @param after id of the last one that was read; null to begin with the first
 * @param limit the most that the part has
 */
class Paging(
    val after: String?,
    val limit: Int = USUAL,
) {
    /** Whether the request asks for a part, and not for the whole list. */
    val isPart: Boolean get() = after != null || limit != WHOLE

    /** How many to read from where the list is stored: one more tells whether the list goes on. */
    val reach: Int = limit + 1

    /** The part of a list of which [read] has what comes next, at most [reach]. */
    fun <T> cut(
        read: List<T>,
        id: (T) -> String,
    ): ListPart<T> {
        val items = read.take(limit)
        return ListPart(items, if (read.size > limit) id(items.last()) else null)
    }

    /**
     * The part of a list that is there as a whole.
     *
     * @throws Rejection.Malformed where nothing in the list has the id
     */
    fun <T> of(
        all: List<T>,
        id: (T) -> String,
    ): ListPart<T> {
        if (after == null) return cut(all, id)
        val last = all.indexOfFirst { id(it) == after }
        if (last < 0) throw unknown()
        return cut(all.drop(last + 1), id)
    }

    /** Says that nothing in the list has the id in [after]. */
    fun unknown() =
        Rejection.Malformed("$AFTER is '$after', expected what an earlier part of this list names as its next")

    companion object {
        const val AFTER = "after"
        const val LIMIT = "limit"

        /** The length of a part of which the request says nothing. */
        const val USUAL = 50

        /** The limit of lists that are given as a whole where the request says nothing. */
        const val WHOLE = Int.MAX_VALUE - 1

        private val LIMITS = 1..1000

        /** @param told in the address; null for [usual] */
        internal fun limit(
            told: String?,
            usual: Int,
        ): Int {
            if (told == null) return usual
            return told.toIntOrNull()?.takeIf { it in LIMITS }
                ?: throw Rejection.Malformed("$LIMIT is '$told', expected ${LIMITS.first} to ${LIMITS.last}")
        }
    }
}

/**
 * Reads from the address which part of a list is asked for.
 *
 * @param usual the limit where none is told
 * @param former another name of `after`, by which programs may still call it
 */
fun ApplicationCall.paging(
    usual: Int = Paging.USUAL,
    former: String = Paging.AFTER,
): Paging {
    val told = request.queryParameters
    return Paging(told[Paging.AFTER] ?: told[former], Paging.limit(told[Paging.LIMIT], usual))
}

/** Tells in the header `Link` where the rest of a list is; nothing where there is none. */
fun ApplicationCall.linkNext(
    part: ListPart<*>,
    former: String = Paging.AFTER,
) {
    if (part.next == null) return
    val asked =
        ParametersBuilder().apply {
            appendAll(request.queryParameters)
            remove(former)
            set(Paging.AFTER, part.next)
        }
    response.header(HttpHeaders.Link, "<${request.path()}?${asked.build().formUrlEncode()}>; rel=\"next\"")
}

/** Answers with a part of a list as an array; the header `Link` tells where the rest is. */
suspend inline fun <reified T> ApplicationCall.respondPart(part: ListPart<T>) {
    linkNext(part)
    respondJson(part.items)
}
