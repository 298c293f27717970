package rasterlab.grader.submission

import org.slf4j.LoggerFactory
import rasterlab.exercises.runner.SpeedMemory
import rasterlab.grader.storage.Database
import java.util.OptionalInt
import kotlin.jvm.optionals.getOrNull

/** The bands of speed in the database, so that a server started anew gives a source the same points. */
class SpeedBands(
    private val database: Database,
) : SpeedMemory {
    private val log = LoggerFactory.getLogger(javaClass)

    override fun band(key: String): OptionalInt {
        val known =
            database.read {
                it
                    .createQuery("SELECT band FROM speed_bands WHERE source_key = :key")
                    .bind("key", key)
                    .mapTo(Int::class.javaObjectType)
                    .findOne()
                    .getOrNull()
            }
        return if (known == null) OptionalInt.empty() else OptionalInt.of(known)
    }

    /** A full disk must not take the whole grading away: the next measurement is then a first one again. */
    override fun keep(
        key: String,
        band: Int,
    ) {
        try {
            database.write {
                it
                    .createUpdate(
                        """INSERT INTO speed_bands (source_key, band) VALUES (:key, :band)
                           ON CONFLICT (source_key) DO UPDATE SET band = excluded.band""",
                    ).bind("key", key)
                    .bind("band", band)
                    .execute()
            }
        } catch (failure: RuntimeException) {
            log.warn("the band of a speed cannot be kept: {}", failure.toString())
        }
    }
}
