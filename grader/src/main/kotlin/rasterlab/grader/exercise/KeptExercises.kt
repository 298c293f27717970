package rasterlab.grader.exercise

import org.slf4j.LoggerFactory
import rasterlab.exercises.CatalogueException
import rasterlab.exercises.Exercise
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.grader.storage.Database
import java.util.Optional
import java.util.concurrent.ConcurrentHashMap
import kotlin.jvm.optionals.getOrNull

/** The files of each exercise at each revision that was ever given out here. */
class KeptExercises(
    private val database: Database,
) {
    private val log = LoggerFactory.getLogger(javaClass)
    private val read = ConcurrentHashMap<Pair<String, String>, Optional<Exercise>>()

    /** Keeps what the exercises of [catalogue] were read from, before anybody hands in for them. */
    fun keep(catalogue: Catalogue) =
        database.write { handle ->
            for (exercise in catalogue.all()) {
                val files = catalogue.files(exercise.id())
                for ((name, content) in files) {
                    handle
                        .createUpdate(
                            """INSERT INTO exercise_files (exercise, revision, name, content)
                               VALUES (:exercise, :revision, :name, :content) ON CONFLICT DO NOTHING""",
                        ).bind("exercise", exercise.id())
                        .bind("revision", exercise.revision())
                        .bind("name", name)
                        .bind("content", content)
                        .execute()
                }
            }
        }

    /** The exercise as it was, or null where it was not kept or cannot be read any more. */
    fun find(
        id: String,
        revision: String,
    ): Exercise? = read.computeIfAbsent(id to revision) { Optional.ofNullable(load(id, revision)) }.getOrNull()

    private fun load(
        id: String,
        revision: String,
    ): Exercise? {
        val files = files(id, revision)
        if (files.isEmpty()) return null
        return try {
            Catalogue.kept(id, files)
        } catch (failure: CatalogueException) {
            log.warn("exercise {} at revision {} cannot be read any more: {}", id, revision, failure.message)
            null
        }
    }

    private fun files(
        id: String,
        revision: String,
    ): Map<String, ByteArray> =
        database.read { handle ->
            handle
                .createQuery("SELECT name, content FROM exercise_files WHERE exercise = :id AND revision = :revision")
                .bind("id", id)
                .bind("revision", revision)
                .map { row, _ -> row.getString("name") to row.getBytes("content") }
                .list()
                .toMap()
        }
}
