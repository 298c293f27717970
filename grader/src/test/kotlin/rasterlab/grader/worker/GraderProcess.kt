package rasterlab.grader.worker

import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CompletableFuture.supplyAsync
import java.util.concurrent.TimeUnit.MINUTES
import kotlin.io.path.readText
import kotlin.random.Random

/** A command of `./lab grader` as a process of its own, from the classes of this test. */
class GraderProcess private constructor(
    val process: Process,
    private val log: Path,
) : AutoCloseable {
    /** Waits for a line that begins with [start], and returns what follows it there. */
    fun line(start: String): String {
        val line = supplyAsync { process.inputReader().readLine() }.orTimeout(2, MINUTES).join()
        check(line != null && line.startsWith(start)) { "expected '$start…', got '$line'; log:\n${log.readText()}" }
        return line.removePrefix(start)
    }

    /** Sends a signal, such as STOP, CONT or TERM. */
    fun signal(name: String) {
        check(ProcessBuilder("kill", "-$name", "${process.pid()}").start().waitFor() == 0) { "no signal $name" }
    }

    /** Ends it as a power cut would. */
    fun kill() {
        process.destroyForcibly().waitFor()
    }

    /** Ends one of the processes that it runs sources in, if there is one. */
    fun killChild(random: Random) {
        process
            .toHandle()
            .descendants()
            .toList()
            .randomOrNull(random)
            ?.destroyForcibly()
    }

    /** Waits for its end, and returns its exit code. */
    fun exit(): Int {
        check(process.waitFor(2, MINUTES)) { "it does not end; log:\n${log.readText()}" }
        return process.exitValue()
    }

    override fun close() {
        kill()
        Files.delete(log)
    }

    companion object {
        fun start(vararg arguments: String): GraderProcess {
            val log = Files.createTempFile("grader-process", ".log")
            val java = Path.of(System.getProperty("java.home"), "bin", "java")
            val options = listOf("-Xmx256m", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC")
            val program = listOf("-cp", System.getProperty("java.class.path"), "rasterlab.grader.MainKt")
            val command = listOf("$java") + options + program + arguments
            return GraderProcess(ProcessBuilder(command).redirectError(log.toFile()).start(), log)
        }
    }
}
