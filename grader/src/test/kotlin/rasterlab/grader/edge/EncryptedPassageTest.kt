package rasterlab.grader.edge

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.certificate.MadeCertificate
import rasterlab.grader.certificate.OwnCertificate
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.ServerSocket
import java.net.Socket
import java.net.SocketAddress
import java.net.StandardSocketOptions
import java.nio.channels.Selector
import java.nio.channels.ServerSocketChannel
import java.nio.channels.SocketChannel
import java.nio.file.Path
import java.time.InstantSource
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CountDownLatch
import kotlin.concurrent.thread

/** Drives one encrypted connection by hand, so that its client reads on only after all else has happened. */
@Timeout(300)
class EncryptedPassageTest {
    @TempDir
    lateinit var folder: Path

    private val home = InetAddress.getLoopbackAddress()

    @Test
    @DisplayName("what is encrypted, but not sent yet, is lost once the engine has ended")
    fun answersArriveWholeThoughTheEngineIsGone() {
        val made = MadeCertificate.make(folder, "server")
        Selector.open().use { selector ->
            ServerSocket(0, 1, home).use { engine ->
                thread { answer(engine) }
                val client = Socket().apply { receiveBufferSize = LITTLE }
                val ends = Ends(made, selector, accepted(client), engine.localSocketAddress)
                val mayRead = CountDownLatch(1)
                val read = CompletableFuture.supplyAsync { read(client, made, mayRead) }
                // Of what this returns, isDone is true only after the wakeup, too late for the loops below.
                read.whenComplete { _, _ -> selector.wakeup() }
                while (!ends.engineHasEnded() && !read.isDone) ends.turn()
                assertTrue(ends.line.isUnsent, "this tests nothing: the network took the whole answer at once")
                mayRead.countDown()
                while (!read.isDone) ends.turn()
                assertEquals(ANSWER.length, read.join().length, "characters of the answer")
                assertTrue(ANSWER == read.join(), "the answer is another one")
                ends.passage.close()
            }
        }
    }

    private fun accepted(client: Socket): SocketChannel =
        ServerSocketChannel.open().use { door ->
            door.bind(InetSocketAddress(home, 0))
            client.connect(door.localAddress)
            door.accept().apply { setOption(StandardSocketOptions.SO_SNDBUF, LITTLE) }
        }

    private fun answer(engine: ServerSocket) =
        engine.accept().use { socket ->
            val lines = socket.getInputStream().bufferedReader()
            generateSequence { lines.readLine().takeIf(String::isNotEmpty) }.forEach { _ -> }
            socket.getOutputStream().write(ANSWER.toByteArray())
        }

    private fun read(
        client: Socket,
        made: MadeCertificate,
        mayRead: CountDownLatch,
    ) = made.trusting.socketFactory.createSocket(client, home.hostAddress, client.port, true).use {
        it.getOutputStream().write("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n".toByteArray())
        mayRead.await()
        String(it.getInputStream().readAllBytes())
    }

    /** The connection from [client] and the one behind it, on the thread that calls. */
    private inner class Ends(
        made: MadeCertificate,
        private val selector: Selector,
        client: SocketChannel,
        engine: SocketAddress,
    ) {
        private var behind: SocketChannel? = null
        private var isComputed = false

        val line =
            ClientLine(
                client,
                OwnCertificate.read(made.certificate, made.key, InstantSource.system()).encryption(),
            ) {
                it.run()
                isComputed = true
            }

        val passage =
            Passage(
                line,
                home,
                selector,
                onClose = {},
                connect = {
                    SocketChannel.open(engine).also {
                        it.configureBlocking(false)
                        behind = it
                    }
                },
                forget = {},
            ).apply { goOn() }

        /** Whether the engine's last byte was read: nothing is awaited of it any more. */
        fun engineHasEnded() = behind?.keyFor(selector)?.interestOps() == 0

        fun turn() {
            if (isComputed) {
                isComputed = false
                passage.computed()
            } else {
                selector.select()
                selector.selectedKeys().clear()
                passage.goOn()
            }
        }
    }

    private companion object {
        /** Bytes that the kernel keeps of a connection, or the few more that it keeps at least. */
        const val LITTLE = 1024

        /** An answer that is one record of TLS. */
        val ANSWER = "HTTP/1.1 200 OK\r\nContent-Length: 15000\r\n\r\n" + "0123456789ABCDE".repeat(1000)
    }
}
