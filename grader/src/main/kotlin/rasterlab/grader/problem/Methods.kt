package rasterlab.grader.problem

import io.ktor.server.request.httpMethod
import io.ktor.server.request.path
import io.ktor.server.routing.HttpMethodRouteSelector
import io.ktor.server.routing.RoutingNode
import io.ktor.server.routing.getAllRoutes

/**
 * Answers any other method with those that a path knows; for when all routes are there.
 * Left to itself, routing says 404 wherever the path has a parameter, and never says `Allow`.
 */
fun RoutingNode.refuseOtherMethods() {
    val known = getAllRoutes().filter { it.selector is HttpMethodRouteSelector }.groupBy { it.parent.address() }
    known.values.forEach { sameAddress ->
        val allowed = sameAddress.map { (it.selector as HttpMethodRouteSelector).method.value }.distinct().sorted()
        sameAddress.mapNotNull { it.parent }.distinct().forEach { place ->
            place.handle { throw Rejection.WrongMethod(call.request.httpMethod.value, call.request.path(), allowed) }
        }
    }
}

/** The path without what stands in it in parentheses: who may come in, and how often. */
private fun RoutingNode?.address() = toString().replace(Regex("""/\([^)]*\)"""), "")
