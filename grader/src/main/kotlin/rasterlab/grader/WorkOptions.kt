package rasterlab.grader

import org.slf4j.LoggerFactory
import picocli.CommandLine
import picocli.CommandLine.Option
import rasterlab.exercises.runner.Isolation
import rasterlab.exercises.runner.Judge
import rasterlab.exercises.runner.JudgeSettings
import rasterlab.exercises.runner.SpeedMemory
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import rasterlab.grader.storage.DataFolder
import rasterlab.grader.worker.HostName
import java.nio.file.Path

/** The options of every process that grades. */
internal class WorkOptions {
    @Option(
        names = ["--name"],
        paramLabel = "NAME",
        descriptionKey = "process.name",
        description = [
            "Name of this process among those that use the database;",
            "default: server for the server, and for a worker the name of its machine.",
        ],
    )
    var name: String? = null

    @Option(
        names = ["--exam"],
        description = ["Refuses to start where sources cannot be isolated by the operating system."],
    )
    var exam = false

    @Option(
        names = ["--java-images"],
        paramLabel = "DIR",
        description = [
            "Folder of the Java that sources run on: images of the modules that they need,",
            "made at the first start; default: cache in the data folder.",
        ],
    )
    var javaImages: Path? = null

    @Option(
        names = ["--config"],
        paramLabel = "FILE",
        description = [
            "Settings in YAML: for each option, but for this one and --heap, a line",
            "with its name without dashes, such as 'port: 8080'.",
            "What is given here counts more.",
        ],
    )
    var config: Path? = null

    @Option(
        names = ["--workers"],
        paramLabel = "N",
        defaultValue = "1",
        description = [
            "Submissions graded at the same time, 1 to 64; default: \${DEFAULT-VALUE}.",
            "With more than half the cores, measured speeds mean little.",
        ],
    )
    var workers = 1

    @Option(
        names = ["--heap"],
        paramLabel = "MIB",
        defaultValue = "256",
        description = [
            "Memory for the server's own objects in MiB, 64 to 65536; default: \${DEFAULT-VALUE}.",
            "The processes that run sources have theirs.",
            "It is ./lab that sets the limit as it starts Java.",
        ],
    )
    var heap = 256

    fun readConfig(command: CommandLine) {
        config?.let { OptionsFile.read(it).applyTo(command) }
    }

    /** @throws CannotStart for the first of them that is out of its range */
    fun requireAllowed() {
        if (workers !in 1..MOST_WORKERS) throw CannotStart(StartFailure.WORKERS, workers, MOST_WORKERS)
        if (heap !in LEAST_HEAP..MOST_HEAP) throw CannotStart(StartFailure.HEAP, heap, LEAST_HEAP, MOST_HEAP)
        name?.let { if (!HostName.isPlain(it)) throw CannotStart(StartFailure.NAME, it) }
    }

    /** Refuses before anything is made: a refused start leaves no folder behind. */
    fun refuseExamsWithoutIsolation() {
        if (!exam) return
        val isolation = Judge.start(JudgeSettings.defaults()).use { it.isolation() }
        val missing = isolation.missingBeforeImages()
        if (!missing.isEmpty) throw CannotStart(StartFailure.EXAM, missing)
    }

    /**
     * The judge of this process, which has the data folder to itself. Where images of Java have to be made first, it
     * grades without them meanwhile, but for exams.
     *
     * @throws CannotStart where exams are asked for and no image of Java could be made
     */
    fun startJudge(
        folder: DataFolder,
        memory: SpeedMemory,
    ): Judge {
        val images = javaImages ?: folder.logFile.resolveSibling("cache")
        val settings = JudgeSettings.defaults().withImages(images)
        val judge = if (exam) Judge.start(settings, memory) else Judge.startAtOnce(settings, memory, ::logIsolation)
        val isolation = judge.isolation()
        logIsolation(isolation)
        if (!exam || isolation.exam()) return judge
        judge.close()
        throw CannotStart(StartFailure.EXAM, isolation.missingForExams())
    }

    /** An option that somebody gave, and that changes nothing, is not passed over in silence. */
    fun tellOtherHeap(
        command: CommandLine,
        words: CommandWords,
    ) {
        val found = Runtime.getRuntime().maxMemory() shr MIB_BITS
        val asked = command.parseResult.hasMatchedOption("--heap")
        if (!asked || found in heap * 3 / 4..heap) return
        command.err.println(words.say("heap.other", "$heap", "$found"))
    }

    companion object {
        private const val MOST_WORKERS = 64
        private const val LEAST_HEAP = 64
        private const val MOST_HEAP = 65_536
        private const val MIB_BITS = 20

        /** The numbers that an option takes. */
        val RANGES = mapOf("--workers" to 1..MOST_WORKERS, "--heap" to LEAST_HEAP..MOST_HEAP)
    }
}

/** A line on what there is, and one for each layer that is missing. */
internal fun isolationLines(
    words: CommandWords,
    isolation: Isolation,
): List<String> {
    val language = words.language.language
    return listOf(words.say("isolation", isolation.holds(language))) +
        isolation.missing().map { words.say("isolation.missing", it.`in`(language)) }
}

internal fun logIsolation(isolation: Isolation) {
    val log = LoggerFactory.getLogger(WorkOptions::class.java)
    log.info("isolation: {}", isolation.holds("en"))
    isolation.missing().forEach { log.info("isolation lacks {}", it) }
}
