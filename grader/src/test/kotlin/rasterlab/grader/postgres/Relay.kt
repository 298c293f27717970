package rasterlab.grader.postgres

import java.io.IOException
import java.net.InetAddress
import java.net.ServerSocket
import java.net.Socket
import java.net.URI
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.CountDownLatch
import kotlin.concurrent.thread

/**
 * A network between a process and a database, which can be cut: nothing gets through then, either way, and nobody is told.
 * It delivers what was sent meanwhile when it is mended, as TCP does.
 *
 * @param server the address of the database
 */
class Relay(
    server: String,
) : AutoCloseable {
    private val target = URI(server)
    private val listening = ServerSocket(0, BACKLOG, InetAddress.getLoopbackAddress())
    private val open = CopyOnWriteArrayList<Socket>()

    @Volatile
    private var whole = CountDownLatch(0)

    /** The address of the same database through this network. */
    val address = server.replace(":${target.port}/", ":${listening.localPort}/")

    init {
        background("accepts") { while (true) join(listening.accept()) }
    }

    fun cut() {
        whole = CountDownLatch(1)
    }

    fun mend() = whole.countDown()

    private fun join(near: Socket) {
        open += near
        background("joins", near) {
            whole.await()
            val far = Socket(target.host, target.port)
            open += far
            background("sends", near, far) { carry(near, far) }
            carry(far, near)
        }
    }

    private fun carry(
        from: Socket,
        to: Socket,
    ) {
        val bytes = ByteArray(BYTES)
        while (true) {
            val count = from.getInputStream().read(bytes)
            whole.await()
            if (count < 0) return to.close()
            to.getOutputStream().write(bytes, 0, count)
        }
    }

    /** @param ends of a connection, both of which are closed where one is */
    private fun background(
        name: String,
        vararg ends: Socket,
        work: () -> Unit,
    ) = thread(isDaemon = true, name = "relay $name") {
        try {
            work()
        } catch (closed: IOException) {
            ends.forEach(Socket::close)
        }
    }

    override fun close() {
        mend()
        listening.close()
        open.forEach(Socket::close)
    }

    private companion object {
        const val BACKLOG = 50
        const val BYTES = 64 * 1024
    }
}
