package rasterlab.grader.edge

import io.ktor.server.application.Application
import io.ktor.server.application.ApplicationCall
import io.ktor.server.cio.CIO
import io.ktor.server.engine.connector
import io.ktor.server.engine.embeddedServer
import io.ktor.server.plugins.origin
import kotlinx.coroutines.runBlocking
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.Socket
import java.nio.ByteBuffer
import javax.net.ssl.SSLContext

/**
 * An application behind its front door, from now on until it is closed.
 *
 * @param encryption null for connections in the clear
 * @param install gets the address of whoever makes a call
 *
 * @throws java.io.IOException when nobody can listen at [address]
 */
class Listening(
    address: InetSocketAddress,
    limits: DoorLimits = DoorLimits(),
    encryption: SSLContext? = null,
    install: Application.((ApplicationCall) -> String) -> Unit,
) : AutoCloseable {
    private val door = Door(address, limits, encryption)
    private val engine =
        embeddedServer(CIO, configure = {
            connector {
                host = LOOPBACK.hostAddress
                port = 0
            }
            connectionIdleTimeoutSeconds = IDLE_SECONDS
        }) { install(::clientOf) }

    /** Where clients connect to. */
    val port get() = door.port

    init {
        engine.start()
        val inner = InetSocketAddress(LOOPBACK, runBlocking { engine.engine.resolvedConnectors() }.first().port)
        loadRefusals(inner)
        door.open(inner)
    }

    override fun close() {
        engine.stop(STOP_MILLIS / 4, STOP_MILLIS)
        door.close()
    }

    private fun clientOf(call: ApplicationCall): String {
        val caller = call.request.origin
        return door.clientOf(caller.remotePort)?.hostAddress ?: caller.remoteAddress
    }

    /**
     * Asks for what is not there, to programs' and to people's pages, so that all that answers failures is loaded
     * while there are files to load it from: a class that could not be loaded once never will be.
     */
    private fun loadRefusals(inner: InetSocketAddress) {
        val person = Requester.of("GET / HTTP/1.1\r\nAccept: text/html\r\nAccept-Language: ru")
        val malformed = RequestFraming().feed(ByteBuffer.wrap(byteArrayOf(0)), ByteBuffer.allocate(0))
        listOfNotNull(malformed, TOO_MANY, NO_ENGINE, CLEAR_TEXT).forEach { it.answer(person) }
        for (target in listOf("/nothing", "/api/v1/nothing", "/api/v1/exercises", "/%zz")) {
            Socket(inner.address, inner.port).use { socket ->
                socket.soTimeout = LOAD_MILLIS
                socket.getOutputStream().write("GET $target HTTP/1.0\r\nHost: localhost\r\n\r\n".toByteArray())
                socket.getInputStream().readAllBytes()
            }
        }
    }

    private companion object {
        val LOOPBACK: InetAddress = InetAddress.getLoopbackAddress()
        const val IDLE_SECONDS = 45
        const val STOP_MILLIS = 2_000L
        const val LOAD_MILLIS = 60_000
    }
}
