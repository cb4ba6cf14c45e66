// How single things are put together of boxes, poles and balls.
#pragma once

#include <explore/simulation/scenes/scene_furniture.h>

#include <string>
#include <utility>

namespace explore::simulation
{
/** Adds parts in the frame of one thing. */
class PieceMaker
{
public:
	PieceMaker(Sketch& sketch, std::string body, Eigen::Vector3d size_m, Eigen::Isometry3d building_from_piece)
	    : m_sketch(sketch), m_body(std::move(body)), m_frame(std::move(building_from_piece)), m_size(std::move(size_m))
	{
	}

	[[nodiscard]] const Eigen::Vector3d& size() const { return m_size; }
	/** The thing's width and depth, about its middle. */
	[[nodiscard]] Span x() const { return around(0, m_size.x()); }
	[[nodiscard]] Span y() const { return around(0, m_size.y()); }
	[[nodiscard]] double top() const { return m_size.z(); }
	Random& random() { return m_sketch.random; }
	std::size_t paint() { return m_sketch.paint(); }
	std::size_t material(std::string_view name, const Eigen::Vector3f& color) { return m_sketch.material(name, color); }

	void box(const Span& x, const Span& y, const Span& z, std::size_t material);
	/** An upright cylinder. */
	void pole(const Eigen::Vector2d& at, const Span& z, double radius_m, std::size_t material, int sides = 12);
	void ball(const Eigen::Vector3d& center, double radius_m, std::size_t material);
	/** A bar on the floor plan from the middle outward. */
	void spoke(double angle_rad, double length_m, const Span& z, double width_m, std::size_t material);
	void mesh(const TriangleMesh& mesh, const Eigen::Isometry3d& piece_from_mesh, std::size_t material);
	/** Four legs of that thickness under a rectangle of the thing's size. */
	void legs(double thickness_m, double height_m, std::size_t material);

private:
	Sketch& m_sketch;
	std::string m_body;
	Eigen::Isometry3d m_frame;
	Eigen::Vector3d m_size;
};

void makeSwivelChair(PieceMaker& make);
void makeFourLeggedChair(PieceMaker& make);
void makeArmchair(PieceMaker& make);
void makeStool(PieceMaker& make);

void makeTable(PieceMaker& make);
void makeDesk(PieceMaker& make);
void makeShelf(PieceMaker& make);
void makeCabinet(PieceMaker& make);
void makeBox(PieceMaker& make);
void makeBin(PieceMaker& make);
void makePlant(PieceMaker& make);
void makeLamp(PieceMaker& make);
void makePedestrian(PieceMaker& make);
}  // namespace explore::simulation
