package rasterlab.grader.storage

import org.postgresql.util.PSQLException
import org.sqlite.SQLiteErrorCode.SQLITE_BUSY
import org.sqlite.SQLiteErrorCode.SQLITE_CANTOPEN
import org.sqlite.SQLiteErrorCode.SQLITE_FULL
import org.sqlite.SQLiteErrorCode.SQLITE_IOERR
import org.sqlite.SQLiteErrorCode.SQLITE_LOCKED
import org.sqlite.SQLiteErrorCode.SQLITE_READONLY
import org.sqlite.SQLiteException
import java.sql.SQLTransientConnectionException

private val WANTING =
    setOf(SQLITE_BUSY, SQLITE_LOCKED, SQLITE_FULL, SQLITE_IOERR, SQLITE_READONLY, SQLITE_CANTOPEN).map { it.code }

/**
 * Beginnings of what PostgreSQL answers when it goes away, is full, was switched to reading, or another has its lock. See
 * https://www.postgresql.org/docs/current/errcodes-appendix.html
 */
private val WANTING_STATES = listOf("08", "53", "57", "58", "25006", "55P03")

/** The low byte of a code; those above it say more of the same kind. */
private const val KIND = 0xff

/** Whether the same write may succeed later: the disk is full or away, or somebody else has the database. */
fun Throwable.isStorageFull(): Boolean =
    generateSequence(this) { it.cause }.any {
        it is SQLTransientConnectionException ||
            (it is SQLiteException && (it.resultCode.code and KIND) in WANTING) ||
            (it is PSQLException && WANTING_STATES.any { begin -> it.sqlState.orEmpty().startsWith(begin) })
    }
