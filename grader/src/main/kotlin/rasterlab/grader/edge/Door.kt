/*
 * The front door of the HTTP server: the one socket that the network sees.
 * It counts connections, lets whole and unambiguous requests through to the engine and sees that every
 * answer arrives. Read Listening, Door, Passage, RequestFraming, in this order.
 */
package rasterlab.grader.edge

import com.sun.management.UnixOperatingSystemMXBean
import org.slf4j.LoggerFactory
import java.io.IOException
import java.lang.management.ManagementFactory
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.StandardSocketOptions
import java.nio.channels.SelectionKey
import java.nio.channels.Selector
import java.nio.channels.ServerSocketChannel
import java.nio.channels.SocketChannel
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.CountDownLatch
import java.util.concurrent.Executors
import javax.net.ssl.SSLContext
import kotlin.concurrent.thread

/**
 * How many connections are open at the same time, beyond which 503 is answered.
 *
 * @param perAddress leaves room for a class behind one router
 * @param proxies who connect for many, so that for them alone [all] counts
 */
data class DoorLimits(
    val all: Int = mostHere(),
    val perAddress: Int = maxOf(all / 4, minOf(all, LEAST)),
    val proxies: Set<InetAddress> = emptySet(),
) {
    private companion object {
        const val MOST = 1024
        const val LEAST = 16

        /** Files of the engine, its storage, the log and the children that grade. */
        const val OTHER_FILES = 160

        /** Files of one connection: the client's, and both ends of the engine's. */
        const val OWN_FILES = 3

        fun mostHere(): Int {
            val system = ManagementFactory.getOperatingSystemMXBean() as? UnixOperatingSystemMXBean ?: return MOST
            val files = (system.maxFileDescriptorCount - OTHER_FILES) / OWN_FILES
            return files.coerceIn(LEAST.toLong(), MOST.toLong()).toInt()
        }
    }
}

/**
 * Takes connections in and passes them on to the engine, which listens where only this machine can reach it.
 * One thread does all of it and never waits for a single connection; a second one computes for those that are
 * encrypted.
 *
 * @param encryption null for connections in the clear
 */
class Door(
    address: InetSocketAddress,
    private val limits: DoorLimits = DoorLimits(),
    private val encryption: SSLContext? = null,
) : AutoCloseable {
    private val log = LoggerFactory.getLogger(javaClass)
    private val selector = Selector.open()
    private val server = ServerSocketChannel.open()
    private val passages = mutableSetOf<Passage>()
    private val clients = ConcurrentHashMap<Int, InetAddress>()
    private val ended = CountDownLatch(1)
    private val computer =
        encryption?.let {
            Executors.newSingleThreadExecutor {
                thread(
                    start = false,
                    isDaemon = true,
                    block = it::run,
                )
            }
        }
    private val computed = ConcurrentLinkedQueue<Passage>()
    private var spare: ServerSocketChannel? = ServerSocketChannel.open()
    private var acceptAgainAt = System.nanoTime()
    private var tellAgainAt = System.nanoTime()
    private var inner = InetSocketAddress(0)

    @Volatile
    private var closing = false

    init {
        try {
            server.setOption(StandardSocketOptions.SO_REUSEADDR, true)
            server.bind(address)
        } catch (failure: IOException) {
            server.close()
            selector.close()
            throw failure
        }
        server.configureBlocking(false)
    }

    /** Where clients connect to. */
    val port = (server.localAddress as InetSocketAddress).port

    /** Begins to let clients through to the engine at [inner]. */
    fun open(inner: InetSocketAddress) {
        this.inner = inner
        val accepting = server.register(selector, SelectionKey.OP_ACCEPT)
        thread(isDaemon = true, name = "rasterlab-door") {
            try {
                while (!closing) turn(accepting)
            } finally {
                computer?.shutdownNow()
                passages.toList().forEach(Passage::close)
                listOfNotNull(server, spare, selector).forEach { it.close() }
                ended.countDown()
            }
        }
    }

    /** Who is at the other end of the engine's connection from [port] of this machine; null for nobody let in here. */
    fun clientOf(port: Int): InetAddress? = clients[port]

    override fun close() {
        closing = true
        selector.wakeup()
        ended.await()
    }

    private fun turn(accepting: SelectionKey) {
        selector.select(TICK_MILLIS)
        val ready = selector.selectedKeys().toList()
        selector.selectedKeys().clear()
        for (key in ready) {
            if (key == accepting) acceptAll(accepting) else keep(key.attachment() as Passage, Passage::goOn)
        }
        generateSequence(computed::poll).forEach { keep(it, Passage::computed) }
        val now = System.nanoTime()
        passages.filter { it.isOverdue(now) }.forEach(Passage::overdue)
        if (!closing) accepting.interestOps(if (now < acceptAgainAt) 0 else SelectionKey.OP_ACCEPT)
    }

    /** One connection's failure must not be the end of all. */
    private fun keep(
        passage: Passage,
        act: Passage.() -> Unit,
    ) {
        try {
            passage.act()
        } catch (failure: RuntimeException) {
            log.error("a connection from {} failed", passage.address, failure)
            passage.close()
        } catch (failure: OutOfMemoryError) {
            passage.close()
            log.error("no memory for a connection from {}", passage.address, failure)
        }
    }

    private fun acceptAll(accepting: SelectionKey) {
        try {
            while (true) enter(server.accept() ?: return)
        } catch (failure: IOException) {
            val now = System.nanoTime()
            if (now > tellAgainAt) log.warn("no connection can be taken in: {}", failure.message)
            tellAgainAt = now + QUIET_NANOS
            shed()
            acceptAgainAt = System.nanoTime() + PAUSE_NANOS
            accepting.interestOps(0)
        }
    }

    /**
     * Turns away the client that waits first when no file is left, by means of the one that is kept
     * for this.
     */
    private fun shed() {
        try {
            spare?.close()
            spare = null
            server.accept()?.close()
            spare = ServerSocketChannel.open()
        } catch (failure: IOException) {
            log.debug("no file is left", failure)
        }
    }

    private fun enter(client: SocketChannel) {
        try {
            if (passages.size >= limits.all + REFUSED_MOST) return client.close()
            val address = (client.remoteAddress as InetSocketAddress).address
            val most = if (address in limits.proxies) limits.all else limits.perAddress
            val refused = passages.size >= limits.all || passages.count { it.address == address } >= most
            lateinit var passage: Passage
            val line = ClientLine(client, encryption) { compute(it, passage) }
            passage = Passage(line, address, selector, passages::remove, ::connect, clients::remove)
            passages += passage
            keep(passage) { if (refused) refuse(TOO_MANY) else goOn() }
        } catch (gone: IOException) {
            client.close()
        }
    }

    private fun compute(
        task: Runnable,
        passage: Passage,
    ) {
        computer?.execute {
            try {
                task.run()
            } finally {
                computed += passage
                selector.wakeup()
            }
        }
    }

    /**
     * Opens a connection to the engine.
     *
     * @throws IOException where the engine would have no file for its end: it would leave the client
     *   waiting, and use up a core in trying again
     */
    private fun connect(client: Passage): SocketChannel {
        val channel = SocketChannel.open()
        try {
            channel.configureBlocking(false)
            channel.bind(InetSocketAddress(inner.address, 0))
            SocketChannel.open().close()
            channel.connect(inner)
            clients[(channel.localAddress as InetSocketAddress).port] = client.address
            return channel
        } catch (failure: IOException) {
            channel.close()
            throw failure
        }
    }

    private companion object {
        const val TICK_MILLIS = 500L
        const val PAUSE_NANOS = 200_000_000L
        const val QUIET_NANOS = 60_000_000_000L

        /** Connections beyond the limits that are told so; of more, nothing is read. */
        const val REFUSED_MOST = 64
    }
}
