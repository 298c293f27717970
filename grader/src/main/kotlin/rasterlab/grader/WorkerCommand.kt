package rasterlab.grader

import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Spec
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.exercises.runner.Judge
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.exercise.KeptExercises
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import rasterlab.grader.storage.DataFolder
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.PostgresAddress
import rasterlab.grader.submission.Attempts
import rasterlab.grader.submission.GradingQueue
import rasterlab.grader.submission.Leases
import rasterlab.grader.submission.Live
import rasterlab.grader.submission.Reports
import rasterlab.grader.submission.SharedMoves
import rasterlab.grader.submission.SpeedBands
import rasterlab.grader.submission.SteadyClock
import rasterlab.grader.submission.Submissions
import rasterlab.grader.worker.HostName
import rasterlab.grader.worker.Presence
import rasterlab.grader.worker.Worker
import rasterlab.grader.worker.Workers
import java.nio.file.Path
import java.time.Duration
import java.time.InstantSource
import java.util.concurrent.Callable

@Command(
    name = "worker",
    mixinStandardHelpOptions = true,
    description = [
        "Grades what servers on other machines take in, from the PostgreSQL database that they share.",
        "Drained on the page of those who grade, it ends first what it grades; told to end by a signal,",
        "it puts that back, and another takes it up at once.",
    ],
)
internal class WorkerCommand(
    private val words: CommandWords,
) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var work: WorkOptions

    @Option(
        names = ["--db"],
        paramLabel = "URL",
        descriptionKey = "worker.db",
        description = ["The servers' database, postgresql://USER@HOST:PORT/NAME; it has to be given."],
    )
    var db: String? = null

    @Option(
        names = ["--data"],
        paramLabel = "DIR",
        defaultValue = "rasterlab-worker",
        descriptionKey = "worker.data",
        description = ["Folder for the log and the Java of sources, made if missing; default: \${DEFAULT-VALUE}."],
    )
    lateinit var data: Path

    override fun call(): Int {
        work.readConfig(spec.commandLine())
        work.requireAllowed()
        val isShared = db?.let { PostgresAddress.of(it) } != null
        if (!isShared) throw CannotStart(StartFailure.WORKER_DATABASE, listOfNotNull("--db", db).joinToString(" "))
        work.tellOtherHeap(spec.commandLine(), words)
        work.refuseExamsWithoutIsolation()
        StopSignal().use { run(work.name ?: HostName.own(), it) }
        return 0
    }

    private fun run(
        name: String,
        stop: StopSignal,
    ) = DataFolder.take(data, db).use { folder ->
        logTo(folder.logFile)
        openDatabase(folder.database, data, name).use { database ->
            work.startJudge(folder, SpeedBands(database)).use { judge ->
                judge.closedByCaller()
                SharedMoves(database, name).use { moves ->
                    queue(name, database, judge, Live(moves::tell), stop).use { queue ->
                        queue.start()
                        announce(name, judge)
                        while (!stop.await(GLANCE)) if (queue.isDrained()) break
                        if (stop.isAsked()) queue.putBack()
                    }
                }
            }
        }
    }

    /** Exercises that are not of this program, or are of another revision there, are in the database. */
    private fun queue(
        name: String,
        database: Database,
        judge: Judge,
        live: Live,
        stop: StopSignal,
    ): GradingQueue {
        val clock = InstantSource.system()
        val steady = SteadyClock(clock)
        val leases = Leases(database, Reports(database), clock, steady, name)
        val exercises = Exercises(Catalogue.builtIn().all(), KeptExercises(database)::find)
        val attempts = Attempts(database, leases, exercises, judge, live, stopping = stop::isAsked)
        val presence =
            Presence(Workers(database, steady, Leases.LENGTH)) {
                Worker.here(name, serves = false, judge.isolation(), work.workers)
            }
        return GradingQueue(
            database,
            Submissions(database),
            leases,
            attempts,
            live,
            steady,
            work.workers,
            name,
            presence,
        )
    }

    /** Announces the worker in every language the same: programs wait for this line. */
    private fun announce(
        name: String,
        judge: Judge,
    ) {
        println("grading as $name")
        System.out.flush()
        isolationLines(words, judge.isolation()).forEach { spec.commandLine().out.println(oneLine(it)) }
    }

    private companion object {
        /** How soon it ends when it is drained. */
        val GLANCE: Duration = Duration.ofMillis(500)
    }
}
