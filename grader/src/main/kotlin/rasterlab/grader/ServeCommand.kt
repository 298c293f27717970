package rasterlab.grader

import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Spec
import rasterlab.exercises.CatalogueException
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.exercises.runner.Isolation
import rasterlab.grader.certificate.OwnCertificate
import rasterlab.grader.edge.DoorLimits
import rasterlab.grader.edge.Listening
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.exercise.KeptExercises
import rasterlab.grader.forwarding.Forwarding
import rasterlab.grader.institution.InstitutionSettings
import rasterlab.grader.limits.IntakeLimits
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import rasterlab.grader.storage.DataFolder
import rasterlab.grader.submission.Leases
import rasterlab.grader.submission.SpeedBands
import java.io.IOException
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.ServerSocket
import java.net.UnknownHostException
import java.nio.file.Path
import java.time.InstantSource
import java.util.concurrent.Callable
import javax.net.ssl.SSLContext

@Command(
    name = "serve",
    mixinStandardHelpOptions = true,
    description = ["Takes in students' sources over HTTP and grades them."],
)
internal class ServeCommand(
    private val words: CommandWords,
) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var work: WorkOptions

    @Option(
        names = ["--data"],
        paramLabel = "DIR",
        defaultValue = "rasterlab-data",
        description = [
            "Folder for the database and the log, made if missing; default: \${DEFAULT-VALUE}.",
        ],
    )
    lateinit var data: Path

    @Option(
        names = ["--host"],
        paramLabel = "HOST",
        defaultValue = "127.0.0.1",
        description = [
            "Address to listen on; 0.0.0.0 for all; default: \${DEFAULT-VALUE}.",
        ],
    )
    lateinit var host: String

    @Option(
        names = ["--port"],
        paramLabel = "PORT",
        defaultValue = "8080",
        description = [
            "Port to listen on; 0 takes a free one; default: \${DEFAULT-VALUE}.",
        ],
    )
    var port = 8080

    @Option(
        names = ["--db"],
        paramLabel = "URL",
        description = [
            "Database, sqlite:FILE or postgresql://USER@HOST:PORT/NAME;",
            "default: rasterlab.db in the data folder.",
        ],
    )
    var db: String? = null

    @Option(
        names = ["--exercises"],
        paramLabel = "DIR",
        description = ["Folder of more exercises, one sub-folder each."],
    )
    var exercises: Path? = null

    @Option(
        names = ["--proxy"],
        paramLabel = "ADDRESS",
        description = [
            "Addresses of reverse proxies, with commas between them: what their headers X-Forwarded-For and",
            "X-Forwarded-Proto say is believed; default: nobody's.",
        ],
    )
    var proxy: String? = null

    @Option(
        names = ["--tls-cert"],
        paramLabel = "FILE",
        description = [
            "Certificate in PEM, with those that signed it behind it; then only HTTPS is spoken.",
            "It is read at the start.",
        ],
    )
    var tlsCert: Path? = null

    @Option(
        names = ["--tls-key"],
        paramLabel = "FILE",
        description = ["The certificate's private key in PEM (PKCS#8, without a password)."],
    )
    var tlsKey: Path? = null

    @Mixin
    val institution = InstitutionOptions()

    @Option(
        names = ["--entries-per-minute"],
        paramLabel = "N",
        defaultValue = "120",
        description = ["Joins and sign-ins from one address, 1 to 100000; default: \${DEFAULT-VALUE}."],
    )
    var entriesPerMinute = 120

    @Option(
        names = ["--submissions-per-minute"],
        paramLabel = "N",
        defaultValue = "20",
        description = ["Submissions of one student, 1 to 100000; default: \${DEFAULT-VALUE}."],
    )
    var submissionsPerMinute = 20

    @Option(
        names = ["--waiting"],
        paramLabel = "N",
        defaultValue = "5",
        description = ["Submissions of one student that may wait, 1 to 100000; default: \${DEFAULT-VALUE}."],
    )
    var waiting = 5

    override fun call(): Int {
        work.readConfig(spec.commandLine())
        if (port !in 0..LAST_PORT) throw CannotStart(StartFailure.PORT, port, LAST_PORT)
        work.requireAllowed()
        requireLimits()
        work.tellOtherHeap(spec.commandLine(), words)
        val proxies = proxies()
        val people = institution.settings(proxied = proxies.isNotEmpty())
        val encryption = encryption()
        val address = address()
        val catalogue = catalogue()
        work.refuseExamsWithoutIsolation()
        StopSignal().use { stop ->
            run(catalogue, address, settings(proxies, encryption != null, people), encryption, stop)
        }
        return 0
    }

    private fun requireLimits() =
        listOf(
            "entries-per-minute" to entriesPerMinute,
            "submissions-per-minute" to submissionsPerMinute,
            "waiting" to waiting,
        ).forEach { (name, limit) ->
            if (limit !in 1..MOST_A_MINUTE) throw CannotStart(StartFailure.LIMIT, name, limit, MOST_A_MINUTE)
        }

    private fun settings(
        proxies: Set<InetAddress>,
        encrypted: Boolean,
        institution: InstitutionSettings?,
    ) = ServerSettings(
        work.workers,
        IntakeLimits(waiting, submissionsPerMinute),
        entriesPerMinute,
        proxies = proxies,
        encrypted = encrypted,
        name = work.name ?: Leases.ONE_SERVER,
        institution = institution,
        publicAddress = this.institution.public(),
    )

    private fun run(
        catalogue: Catalogue,
        address: InetSocketAddress,
        settings: ServerSettings,
        encryption: SSLContext?,
        stop: StopSignal,
    ) {
        DataFolder.take(data, db).use { folder ->
            logTo(folder.logFile)
            openDatabase(folder.database, data, work.name ?: Leases.ONE_SERVER).use { database ->
                work.startJudge(folder, SpeedBands(database)).use { judge ->
                    val kept = KeptExercises(database).apply { keep(catalogue) }
                    Server(
                        database,
                        Exercises(catalogue.all(), kept::find),
                        judge,
                        judge::isolation,
                        settings,
                        stopping = stop::isAsked,
                        children = judge::livingChildren,
                    ).use { server ->
                        Listening(
                            address,
                            DoorLimits(proxies = settings.proxies),
                            encryption,
                        ) { server.install(this, it) }
                            .use {
                                serve(
                                    server,
                                    judge.isolation(),
                                    if (encryption ==
                                        null
                                    ) {
                                        "http"
                                    } else {
                                        "https"
                                    },
                                    it.port,
                                    stop,
                                )
                            }
                    }
                }
            }
        }
    }

    private fun proxies(): Set<InetAddress> =
        proxy?.let { Forwarding.proxies(it) ?: throw CannotStart(StartFailure.PROXY, it) }.orEmpty()

    private fun encryption(): SSLContext? {
        if ((tlsCert == null) != (tlsKey == null)) throw CannotStart(StartFailure.TLS_PAIR)
        val certificate = tlsCert ?: return null
        val key = tlsKey ?: return null
        return OwnCertificate.read(certificate, key, InstantSource.system()).encryption()
    }

    private fun address(): InetSocketAddress {
        val address =
            try {
                InetSocketAddress(InetAddress.getByName(host), port)
            } catch (failure: UnknownHostException) {
                throw CannotStart(StartFailure.HOST, host)
            }
        // The engine reports a port that is taken from another thread, and late; asking first gives a clear line.
        try {
            ServerSocket().use { socket ->
                socket.reuseAddress = true
                socket.bind(address)
            }
        } catch (failure: IOException) {
            val why = failure.message.orEmpty()
            throw when {
                why.startsWith("Address already in use") -> CannotStart(StartFailure.TAKEN, host, port)
                why.startsWith("Cannot assign requested address") -> CannotStart(StartFailure.UNASSIGNED, host, port)
                why.startsWith("Permission denied") -> CannotStart(StartFailure.FORBIDDEN, host, port)
                else -> CannotStart(StartFailure.LISTEN, host, port, why)
            }
        }
        return address
    }

    private fun catalogue(): Catalogue {
        try {
            val builtIn = Catalogue.builtIn()
            val more = exercises ?: return builtIn
            val all = builtIn.withFolder(more)
            OwnExercises(more, all.all().filter { one -> builtIn.all().none { it === one } }, all.replaced())
                .told(words)
                .forEach { spec.commandLine().err.println(oneLine(it)) }
            return all
        } catch (failure: CatalogueException) {
            throw CannotStart(StartFailure.EXERCISES, failure)
        }
    }

    /** Returns when the process is told to stop and no request is accepted any more. */
    private fun serve(
        server: Server,
        isolation: Isolation,
        scheme: String,
        port: Int,
        stop: StopSignal,
    ) {
        server.startGrading()
        announce(server, scheme, port)
        isolationLines(words, isolation).forEach { spec.commandLine().out.println(oneLine(it)) }
        stop.await()
    }

    /** Announces the server in every language the same: programs wait for these lines. */
    private fun announce(
        server: Server,
        scheme: String,
        port: Int,
    ) {
        println("listening on $scheme://${if (':' in host) "[$host]" else host}:$port")
        server.accounts.newInstructorToken()?.let { token ->
            println("instructor token: $token")
            System.out.flush()
            server.accounts.instructorAnnounced()
        }
    }

    companion object {
        private const val LAST_PORT = 65_535
        private const val MOST_A_MINUTE = 100_000

        /** The numbers that an option takes. */
        val RANGES =
            WorkOptions.RANGES +
                mapOf(
                    "--port" to 0..LAST_PORT,
                    "--entries-per-minute" to 1..MOST_A_MINUTE,
                    "--submissions-per-minute" to 1..MOST_A_MINUTE,
                    "--waiting" to 1..MOST_A_MINUTE,
                )
    }
}
