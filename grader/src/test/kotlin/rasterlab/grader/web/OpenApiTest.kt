package rasterlab.grader.web

import io.ktor.client.request.get
import io.ktor.http.HttpMethod
import io.ktor.server.routing.HttpMethodRouteSelector
import io.ktor.server.routing.RoutingNode
import io.ktor.server.routing.RoutingRoot
import io.ktor.server.routing.getAllRoutes
import io.ktor.server.routing.routing
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.engine.ProductVersion
import rasterlab.grader.Classroom
import rasterlab.grader.json
import java.nio.file.Path

class OpenApiTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun describesTheRoutesThereAreAndNoOthers() =
        Classroom(folder).open(grades = false) {
            val served = mutableSetOf<String>()
            application.application {
                routing { served += (this as RoutingRoot).getAllRoutes().mapNotNull(::call) }
            }
            application.startApplication()
            val described =
                client.get("/openapi.json").json().getValue("paths").jsonObject.flatMap { (path, methods) ->
                    methods.jsonObject.keys.map { "${it.uppercase()} $path" }
                }
            assertEquals(served.sorted(), described.sorted())
        }

    @Test
    fun namesTheVersionThatTheBuildGave() =
        Classroom(folder).open(grades = false) {
            val info =
                client
                    .get("/openapi.json")
                    .json()
                    .getValue("info")
                    .jsonObject
            assertEquals(ProductVersion.text(), info.getValue("version").jsonPrimitive.content)
            assertTrue(ProductVersion.text().matches(Regex("""\d+\.\d+\.\d+.*""")), ProductVersion.text())
        }

    private fun call(route: RoutingNode): String? {
        val selector = route.selector as? HttpMethodRouteSelector ?: return null
        val method: HttpMethod = selector.method
        val path = route.parent.toString().replace(Regex("""/\([^)]*\)"""), "")
        return "${method.value} $path".takeIf { path.startsWith("/api/") || path in MONITORING }
    }

    private companion object {
        val MONITORING = setOf("/openapi.json", "/healthz", "/readyz", "/metrics")
    }
}
