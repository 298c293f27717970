package rasterlab.grader

import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import rasterlab.grader.course.Accounts
import rasterlab.grader.storage.Backups
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import rasterlab.grader.storage.DataFolder
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.PostgresAddress
import rasterlab.grader.storage.SqliteFile
import java.nio.file.Path
import java.time.InstantSource
import java.util.concurrent.Callable

/** Which server's database is meant. */
internal class DataOptions {
    @Option(
        names = ["--data"],
        paramLabel = "DIR",
        defaultValue = "rasterlab-data",
        descriptionKey = "data.of",
        description = ["The server's data folder; default: \${DEFAULT-VALUE}."],
    )
    lateinit var data: Path

    @Option(
        names = ["--db"],
        paramLabel = "URL",
        descriptionKey = "db",
        description = [
            "Database, sqlite:FILE or postgresql://USER@HOST:PORT/NAME;",
            "default: rasterlab.db in the data folder.",
        ],
    )
    var db: String? = null

    /** The database, also while the server runs. */
    fun open(): Database = openDatabase(DataFolder.databaseOf(data, db), data)

    /** @throws CannotStart where the database is in no file, which has backups of another kind */
    fun requireFile() {
        db?.let { PostgresAddress.of(it) }?.let { throw CannotStart(StartFailure.BACKUP_POSTGRES, it) }
    }
}

@Command(
    name = "backup",
    mixinStandardHelpOptions = true,
    description = [
        "Copies the server's database to a new file, also while the server runs.",
        "Copying the folder of a running server is no backup: what was written last is missing or half there.",
    ],
)
internal class BackupCommand(
    private val words: CommandWords,
) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var of: DataOptions

    @Parameters(paramLabel = "FILE", descriptionKey = "backup.file", description = ["Where to; must not be there yet."])
    lateinit var file: Path

    override fun call(): Int {
        of.requireFile()
        Backups.take((DataFolder.databaseOf(of.data, of.db) as SqliteFile).path, file)
        spec.commandLine().out.println(oneLine(words.say("backed.up", "$file")))
        return 0
    }
}

@Command(
    name = "restore",
    mixinStandardHelpOptions = true,
    description = ["Puts a backup in the place of the database of a server that does not run."],
)
internal class RestoreCommand(
    private val words: CommandWords,
) : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var of: DataOptions

    @Parameters(paramLabel = "FILE", descriptionKey = "restore.file", description = ["A file that backup made."])
    lateinit var file: Path

    override fun call(): Int {
        of.requireFile()
        Backups.refuseUnlessWhole(file)
        DataFolder.take(of.data, of.db, StartFailure.USED_RESTORE).use { folder ->
            val former = Backups.restore(file, folder.databaseFile)
            val out = spec.commandLine().out
            out.println(oneLine(words.say("restored", "${folder.databaseFile}", "$file")))
            former?.let { out.println(oneLine(words.say("restored.former", "$it"))) }
        }
        return 0
    }
}

@Command(
    name = "token",
    mixinStandardHelpOptions = true,
    description = [
        "Makes a new token in the place of a lost one, which stops working at once.",
        "The server may run meanwhile.",
    ],
)
internal class TokenCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var of: DataOptions

    @Parameters(
        paramLabel = "WHO",
        defaultValue = INSTRUCTOR,
        descriptionKey = "token.who",
        description = ["instructor, or a student's id; default: \${DEFAULT-VALUE}."],
    )
    lateinit var who: String

    /** The line is the same in every language: programs wait for it, as for that of serve. */
    override fun call(): Int {
        val place = DataFolder.databaseOf(of.data, of.db)
        openDatabase(place, of.data).use { database ->
            val accounts = Accounts(database, InstantSource.system())
            val token =
                if (who == INSTRUCTOR) {
                    accounts.renewInstructor() ?: throw CannotStart(StartFailure.NO_INSTRUCTOR, place)
                } else {
                    accounts.renewStudent(who, by = "command", key = null)
                        ?: throw CannotStart(StartFailure.NO_STUDENT, who)
                }
            spec.commandLine().out.println("${if (who == INSTRUCTOR) who else "student"} token: $token")
        }
        return 0
    }

    private companion object {
        const val INSTRUCTOR = "instructor"
    }
}
