package rasterlab.grader.storage

import rasterlab.exercises.CatalogueException
import rasterlab.exercises.score.Message
import rasterlab.grader.wording.Wording
import java.util.Locale

/**
 * The server, or a command beside it, cannot start; the message is one line for the person who started it.
 *
 * @param values for the places {0}, {1}, … of the reason's words; what has words in their language takes these
 */
class CannotStart(
    private val reason: StartFailure,
    vararg values: Any,
    cause: Throwable? = null,
) : Exception(cause) {
    /** @param key of the words in reasons.properties */
    enum class StartFailure(
        val key: String,
    ) {
        PORT("port"),
        WORKERS("workers"),
        WORKER_DATABASE("worker.database"),
        NAME("name"),
        NAME_USED("name.used"),
        HEAP("heap"),
        LIMIT("limit"),
        EXAM("exam"),
        HOST("host"),
        LISTEN("listen"),
        UNASSIGNED("unassigned"),
        FORBIDDEN("forbidden"),
        TAKEN("taken"),
        EXERCISES("exercises"),
        DATABASE("database"),
        DB_KIND("db.kind"),
        DB_ADDRESS("db.address"),
        DB_SILENT("db.silent"),
        DB_ENTRY("db.entry"),
        DB_ABSENT("db.absent"),
        DB_NEWER("db.newer"),
        DB_NAME("db.name"),
        DB_FOLDER("db.folder"),
        DB_NONE("db.none"),
        DB_LINKED("db.linked"),
        DATA_FILE("data.file"),
        DATA_MADE("data.made"),
        USED("used"),
        USED_RESTORE("used.restore"),
        WRITTEN("written"),
        NO_DATABASE("no.database"),
        NO_INSTRUCTOR("no.instructor"),
        NO_STUDENT("no.student"),
        NO_STAFF("no.staff"),
        NO_PLATFORM("no.platform"),
        LAST_INSTRUCTOR("last.instructor"),
        NO_COURSE("no.course"),
        NO_EXERCISE("no.exercise"),
        ROSTER_FILE("roster.file"),
        EXPORT_THERE("export.there"),
        EXPORT_FOLDER("export.folder"),
        EXPORT_DENIED("export.denied"),
        EXPORT_FAILED("export.failed"),
        PROXY("proxy"),
        TLS_PAIR("tls.pair"),
        TLS_FILE("tls.file"),
        TLS_CERTIFICATE("tls.certificate"),
        TLS_BROKEN("tls.broken"),
        TLS_EARLY("tls.early"),
        TLS_EXPIRED("tls.expired"),
        TLS_KEY("tls.key"),
        TLS_LOCKED("tls.locked"),
        TLS_OLDER("tls.older"),
        TLS_OTHER_KEY("tls.other.key"),
        TLS_MISMATCH("tls.mismatch"),
        SIGN_IN_BOTH("sign.in.both"),
        SIGN_IN_ALONE("sign.in.alone"),
        SIGN_IN_ADDRESS("sign.in.address"),
        SIGN_IN_HEADER("sign.in.header"),
        SIGN_IN_COLUMN("sign.in.column"),
        SIGN_IN_FILE("sign.in.file"),
        SIGN_IN_SECRET("sign.in.secret"),
        SIGN_IN_STAFF("sign.in.staff"),
        CONFIG_NONE("config.none"),
        CONFIG_UNREADABLE("config.unreadable"),
        CONFIG_LONG("config.long"),
        CONFIG_YAML("config.yaml"),
        CONFIG_SHAPE("config.shape"),
        CONFIG_KEY("config.key"),
        CONFIG_TWICE("config.twice"),
        CONFIG_NUMBER("config.number"),
        CONFIG_TRUTH("config.truth"),
        CONFIG_TEXT("config.text"),
        BACKUP_POSTGRES("backup.postgres"),
        BACKUP_THERE("backup.there"),
        BACKUP_IS_FOLDER("backup.is.folder"),
        BACKUP_FOLDER("backup.folder"),
        BACKUP_NONE("backup.none"),
        BACKUP_BROKEN("backup.broken"),
        BACKUP_NO_DATABASE("backup.no.database"),
        BACKUP_FOREIGN("backup.foreign"),
        BACKUP_FAILED("backup.failed"),
    }

    private val values = values.toList()

    override val message: String = said(Locale.ENGLISH)

    fun said(language: Locale): String {
        val said = values.map { it.saidIn(language.language) }
        return Wording("rasterlab.grader.storage.reasons", language).say(reason.key, *said.toTypedArray())
    }

    private fun Any.saidIn(language: String): String =
        when (this) {
            is Message -> `in`(language)
            is CatalogueException -> `in`(language)
            else -> toString()
        }
}
