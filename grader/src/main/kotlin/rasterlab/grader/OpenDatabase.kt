package rasterlab.grader

import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.DatabasePlace
import rasterlab.grader.storage.NewerTables
import rasterlab.grader.storage.PostgresAddress
import rasterlab.grader.storage.SqliteFile
import java.nio.file.Path

/**
 * Opens the database of a server.
 *
 * @param folder the server's data folder
 * @param name of the process, which no other may have that uses it; null for a command, which grades nothing
 * @throws CannotStart with the reason that lies deepest, as those above it say only that opening failed
 */
internal fun openDatabase(
    place: DatabasePlace,
    folder: Path,
    name: String? = null,
): Database =
    try {
        when (place) {
            is SqliteFile -> Database.open(place.path)
            is PostgresAddress -> Database.open(place, folder, name)
        }
    } catch (newer: NewerTables) {
        throw CannotStart(StartFailure.DB_NEWER, place, newer.version, cause = newer)
    } catch (failure: RuntimeException) {
        throw CannotStart(StartFailure.DATABASE, place, failure.reason(), cause = failure)
    }
