package rasterlab.grader.edge

import java.io.IOException
import java.net.InetAddress
import java.net.StandardSocketOptions
import java.nio.ByteBuffer
import java.nio.channels.SelectionKey
import java.nio.channels.Selector
import java.nio.channels.SocketChannel

/**
 * One client's connection and, from its first whole request on, the one to the engine behind it.
 *
 * Ends when the engine has: then what the client still sends is read and dropped for a while, because
 * closing a connection with unread bytes takes the answer away from a client that is still sending.
 */
internal class Passage(
    private val client: ClientLine,
    val address: InetAddress,
    private val selector: Selector,
    private val onClose: (Passage) -> Unit,
    private val connect: (Passage) -> SocketChannel,
    private val forget: (Int) -> Unit,
) {
    private val framing = RequestFraming()
    private val fromClient: SelectionKey
    private var engine: SocketChannel? = null
    private var enginePort = 0
    private var fromEngine: SelectionKey? = null
    private val toEngine = Pending(TO_ENGINE_BYTES)
    private val toClient = Pending(TO_CLIENT_BYTES)

    /** Nothing more goes to the engine: the client has ended, or is refused. */
    private var requestsEnded = false
    private var engineToldEnd = false
    private var answersEnded = false
    private var refusal: Refusal? = null

    /** The refusal waits for the request, which tells who reads it, up to the deadline. */
    private var listening = false
    private var lingering = false
    private var dropped = 0L
    private var closed = false

    /** The deadline by System.nanoTime; null where the engine watches over the time. */
    private var deadline: Long? = System.nanoTime() + IDLE_NANOS

    init {
        client.socket.configureBlocking(false)
        fromClient = client.socket.register(selector, 0, this)
    }

    /** Answers that to the first request, or soon where none comes, instead of what the engine would. */
    fun refuse(refusal: Refusal) {
        this.refusal = refusal
        listening = true
        deadline = System.nanoTime() + LISTEN_NANOS
        goOn()
    }

    /** Ends the connection, or the waiting for the request that is to be refused. */
    fun overdue() {
        if (!listening) return close()
        endListening()
        goOn()
    }

    private fun endListening() {
        listening = false
        requestsEnded = true
        toEngine.clear()
        deadline = System.nanoTime() + WRITE_NANOS
    }

    /** Does what can be done without waiting. */
    fun goOn() {
        if (closed) return
        try {
            do {
                val moved = readClient() or writeEngine() or readEngine() or writeClient()
            } while (moved && !closed)
            if (!closed) await()
        } catch (gone: IOException) {
            // the client has broken off: what the engine answers is for nobody
            close()
        }
    }

    /** Goes on after a computation that the client's line asked for. */
    fun computed() {
        client.computed()
        goOn()
    }

    fun isOverdue(now: Long) = deadline.let { it != null && now - it > 0 }

    fun close() {
        if (closed) return
        closed = true
        if (enginePort != 0) forget(enginePort)
        engine?.close()
        client.close()
        onClose(this)
    }

    private fun readClient(): Boolean {
        if (lingering) return drop()
        if (requestsEnded || toEngine.space < RequestFraming.MOST_HEAD + SCRATCH_BYTES) return false
        val arrived = ByteBuffer.allocate(SCRATCH_BYTES)
        val count = client.read(arrived)
        if (client.isMistaken) return refuseClearText()
        if (count == 0) return false
        val wrong = if (count < 0) framing.atEnd() else toEngine.fill { framing.feed(arrived.flip(), it) }
        requestsEnded = count < 0 || wrong != null
        if (listening && (requestsEnded || !toEngine.isEmpty)) {
            endListening()
        } else if (wrong != null) {
            refusal = wrong
            if (framing.isWithinRequest) breakOff()
        }
        return true
    }

    private fun refuseClearText(): Boolean {
        listening = false
        requestsEnded = true
        refusal = CLEAR_TEXT
        return true
    }

    /** The engine takes a body that ends too early for a whole one, unless its connection is reset. */
    private fun breakOff() {
        engine?.setOption(StandardSocketOptions.SO_LINGER, 0)?.close()
        engine = null
        fromEngine = null
        answersEnded = true
        toEngine.clear()
    }

    private fun drop(): Boolean {
        val count = client.drop(ByteBuffer.allocate(SCRATCH_BYTES))
        dropped += maxOf(count, 0)
        if (count < 0 || dropped > DROPPED_MOST) close()
        return count > 0
    }

    private fun writeEngine(): Boolean {
        if (listening) return false
        if (engine == null && toEngine.isEmpty) return endWithoutEngine()
        val channel = engine ?: connected() ?: return true
        if (engineToldEnd || !(channel.isConnected || finishConnect(channel))) return false
        try {
            val moved = toEngine.drain(channel::write)
            if (requestsEnded && toEngine.isEmpty) {
                channel.shutdownOutput()
                engineToldEnd = true
            }
            return moved
        } catch (hungUp: IOException) {
            // it has answered without reading on, and what it said is still to be read
            engineToldEnd = true
            return true
        }
    }

    private fun endWithoutEngine(): Boolean {
        if (!requestsEnded || answersEnded) return false
        answersEnded = true
        return true
    }

    private fun connected(): SocketChannel? =
        try {
            val channel = connect(this)
            engine = channel
            enginePort = channel.socket().localPort
            fromEngine = channel.register(selector, 0, this)
            deadline = null
            channel
        } catch (noFileOrNobody: IOException) {
            failed()
            null
        }

    private fun finishConnect(channel: SocketChannel): Boolean =
        try {
            channel.finishConnect()
        } catch (nobody: IOException) {
            failed()
            false
        }

    private fun failed() {
        refusal = NO_ENGINE
        requestsEnded = true
        engineToldEnd = true
        answersEnded = true
        toEngine.clear()
    }

    private fun readEngine(): Boolean {
        val channel = engine ?: return false
        if (answersEnded || !channel.isConnected || toClient.space == 0) return false
        try {
            val count = toClient.fill(channel::read)
            if (count < 0) answersEnded = true
            return count != 0
        } catch (hungUp: IOException) {
            answersEnded = true
            return true
        }
    }

    private fun writeClient(): Boolean {
        if (lingering) return false
        val moved = toClient.drain(client::write) || client.flush()
        if (!toClient.isEmpty || client.isUnsent) {
            if (moved || deadline == null) deadline = System.nanoTime() + WRITE_NANOS
            return moved
        }
        if (!answersEnded) {
            if (engine != null) deadline = null
            return moved
        }
        val last = refusal
        if (last != null) {
            refusal = null
            toClient.fill { it.put(last.answer(framing.asker)) }
            return true
        }
        client.shutdownOutput()
        requestsEnded = true
        lingering = true
        deadline = System.nanoTime() + LINGER_NANOS
        return true
    }

    private fun await() {
        val reads = lingering || (!requestsEnded && toEngine.space >= RequestFraming.MOST_HEAD + SCRATCH_BYTES)
        fromClient.interestOps(if (lingering) SelectionKey.OP_READ else client.ops(reads, !toClient.isEmpty))
        val channel = engine ?: return
        val pending = !engineToldEnd && !(toEngine.isEmpty && !requestsEnded)
        fromEngine?.interestOps(
            when {
                answersEnded -> 0
                !channel.isConnected -> SelectionKey.OP_CONNECT
                else -> ops(SelectionKey.OP_READ, toClient.space > 0) or ops(SelectionKey.OP_WRITE, pending)
            },
        )
    }

    private fun ops(
        operation: Int,
        wanted: Boolean,
    ) = if (wanted) operation else 0

    private companion object {
        const val SCRATCH_BYTES = 8 * 1024
        const val TO_ENGINE_BYTES = RequestFraming.MOST_HEAD + 2 * SCRATCH_BYTES
        const val TO_CLIENT_BYTES = 16 * 1024
        const val DROPPED_MOST = 32L shl 20
        const val SECOND = 1_000_000_000L

        /**
         * The time for the first whole head. The engine itself ends connections that are idle
         * later.
         */
        const val IDLE_NANOS = 45 * SECOND

        /** The time for the head of a request that is refused whatever it asks. */
        const val LISTEN_NANOS = SECOND / 2

        /** The time for a client to take some of its answer. */
        const val WRITE_NANOS = 60 * SECOND
        const val LINGER_NANOS = 20 * SECOND
    }
}

/** Bytes on their way, in memory that is taken when the first one comes. */
private class Pending(
    private val size: Int,
) {
    private var bytes: ByteBuffer? = null

    val isEmpty get() = (bytes?.position() ?: 0) == 0

    val space get() = bytes?.remaining() ?: size

    fun <T> fill(from: (ByteBuffer) -> T): T = from(bytes ?: ByteBuffer.allocate(size).also { bytes = it })

    /** Whether some went. */
    fun drain(to: (ByteBuffer) -> Int): Boolean {
        val waiting = bytes?.flip() ?: return false
        try {
            return waiting.hasRemaining() && to(waiting) > 0
        } finally {
            waiting.compact()
        }
    }

    fun clear() {
        bytes = null
    }
}
