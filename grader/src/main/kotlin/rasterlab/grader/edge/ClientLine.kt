package rasterlab.grader.edge

import tlschannel.NeedsReadException
import tlschannel.NeedsTaskException
import tlschannel.NeedsWriteException
import tlschannel.ServerTlsChannel
import tlschannel.TlsChannel
import java.nio.ByteBuffer
import java.nio.channels.ByteChannel
import java.nio.channels.SelectionKey
import java.nio.channels.SocketChannel
import javax.net.ssl.SSLContext
import javax.net.ssl.SSLException

/**
 * A client's connection, in the clear or by TLS. Neither reading nor writing waits: 0 says that nothing goes just now,
 * and [ops] for what to look before trying again.
 *
 * @param encryption null for a connection in the clear
 * @param compute runs the arithmetic of a handshake beside the thread that calls, and has [computed] called after it
 */
internal class ClientLine(
    val socket: SocketChannel,
    encryption: SSLContext?,
    private val compute: (Runnable) -> Unit,
) {
    private val raw = FirstByte(socket)
    private var tls: TlsChannel? =
        encryption?.let { ServerTlsChannel.newBuilder(raw, it).withRunTasks(false).build() }
    private var computing = false
    private var readNeeds = SelectionKey.OP_READ
    private var writeNeeds = SelectionKey.OP_WRITE

    /** Encrypted bytes are made that the network has not taken yet. */
    var isUnsent = false
        private set

    /** The client speaks HTTP in the clear where TLS is spoken; it is answered in the clear. */
    var isMistaken = false
        private set

    /** Returns the number of bytes, or -1 at the end. */
    fun read(into: ByteBuffer): Int {
        val channel = tls ?: return socket.read(into)
        if (computing) return 0
        readNeeds = SelectionKey.OP_READ
        return try {
            channel.read(into)
        } catch (needs: NeedsReadException) {
            0
        } catch (needs: NeedsWriteException) {
            isUnsent = true
            readNeeds = SelectionKey.OP_WRITE
            0
        } catch (needs: NeedsTaskException) {
            start(needs.task)
        } catch (failure: SSLException) {
            if (raw.first !in CAPITALS) throw failure
            isMistaken = true
            tls = null
            0
        }
    }

    /** Returns how many bytes were taken from there. */
    fun write(from: ByteBuffer): Int {
        val channel = tls ?: return socket.write(from)
        if (computing) return 0
        writeNeeds = SelectionKey.OP_WRITE
        val before = from.remaining()
        // Whatever else it waits for, it sends first what was encrypted before.
        isUnsent = false
        try {
            channel.write(from)
        } catch (needs: NeedsReadException) {
            writeNeeds = SelectionKey.OP_READ
        } catch (needs: NeedsWriteException) {
            isUnsent = true
        } catch (needs: NeedsTaskException) {
            start(needs.task)
        }
        return before - from.remaining()
    }

    /** Goes on sending what is encrypted; tells whether the last of it went. */
    fun flush(): Boolean {
        if (!isUnsent || computing) return false
        write(ByteBuffer.allocate(0))
        return !isUnsent
    }

    /** Reads what is not for anybody any more, so without decrypting it. */
    fun drop(into: ByteBuffer): Int = socket.read(into)

    /** Returns what the selector is to look for where somebody wants to read or to write. */
    fun ops(
        reading: Boolean,
        writing: Boolean,
    ): Int {
        if (computing) return 0
        val read = if (reading) readNeeds else 0
        val write = if (writing) writeNeeds else 0
        return read or write or if (isUnsent) SelectionKey.OP_WRITE else 0
    }

    /** The arithmetic that was started has ended. */
    fun computed() {
        computing = false
    }

    /** Says that no more is sent; only after all that was written is sent. */
    fun shutdownOutput() {
        try {
            tls?.shutdown()
        } catch (full: NeedsWriteException) {
            // only the farewell does not go, and what came before it told its length
        }
        socket.shutdownOutput()
    }

    fun close() {
        tls?.close()
        socket.close()
    }

    private fun start(task: Runnable): Int {
        computing = true
        compute(task)
        return 0
    }

    private companion object {
        /** Letters that a request in the clear begins with, and a handshake does not. */
        val CAPITALS = 'A'.code..'Z'.code
    }
}

/** Remembers the first byte that came. */
private class FirstByte(
    private val socket: SocketChannel,
) : ByteChannel by socket {
    var first = -1
        private set

    override fun read(into: ByteBuffer): Int {
        val start = into.position()
        val count = socket.read(into)
        if (first < 0 && count > 0) first = into.get(start).toInt() and UNSIGNED
        return count
    }

    private companion object {
        const val UNSIGNED = 0xff
    }
}
